"""Blender must find in our files what FILE.expected.json beside each says: armatures with the right bones, rest pose,
frame rate and duration, joints where they are at keys and half-way between them, and vertices that follow.

Usage: blender -b --factory-startup --python-exit-code 1 --python check_blender.py -- FOLDER fbx|gltf|bvh
"""
import builtins
import contextlib
import io
import json
import logging
import pathlib
import sys

import bpy
import numpy

# Blender 3.4's importers open files in a mode and use a name of numpy that Debian's Python and numpy no longer have.
if not hasattr(numpy, "bool"):
    numpy.bool = bool
import io_anim_bvh.import_bvh as import_bvh  # noqa: E402 (after the patch)
import io_scene_fbx.import_fbx as import_fbx  # noqa: E402

import_bvh.open = lambda path, mode="r", **options: builtins.open(path, mode.replace("U", ""), **options)

# It takes the rounded frame rate when it places keys: at 29.97 frames a second they would come in frames of 30.
place_keys = import_fbx.blen_read_animations_action_item
import_fbx.blen_read_animations_action_item = lambda action, item, curves, fps, *rest: place_keys(
    action, item, curves, fps / bpy.context.scene.render.fps_base, *rest)

LARGEST_VERTEX_ERROR_M = 1e-3
LARGEST_REST_ERROR_M = 1e-5
LARGEST_REST_TURN = 1e-3  # of a unit vector; Blender makes short bones' directions from 32-bit ends


def distance(found, expected):
    found, expected = numpy.array(found), numpy.array(expected)
    return float(numpy.linalg.norm(found - expected, axis=-1).max())


def import_file(path, expected):
    """Imports and returns how many frames a second are and at which of them time 0 is."""
    scene = bpy.context.scene
    with contextlib.redirect_stdout(io.StringIO()):
        if path.suffix == ".fbx":
            bpy.ops.import_scene.fbx(filepath=str(path))
        elif path.suffix == ".bvh":
            # As Euler angles of its own axes Blender loses up to a few 1e-4 rad near *their* gimbal lock.
            bpy.ops.import_anim.bvh(filepath=str(path), global_scale=expected["metres_per_unit"],
                                    update_scene_fps=True, rotate_mode="QUATERNION")
        else:
            # glTF knows seconds alone; it places keys by the whole number of frames.
            scene.render.fps = round(expected["fps"])
            scene.render.fps_base = 1.0
            bpy.ops.import_scene.gltf(filepath=str(path), loglevel=logging.ERROR)
            return scene.render.fps, 0.0
    return scene.render.fps / scene.render.fps_base, 1.0


class File:
    def __init__(self, path):
        self.path = path
        self.expected = json.loads(pathlib.Path(f"{path}.expected.json").read_text())
        self.problems = []
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.fps, self.start = import_file(path, self.expected)
        if self.expected["foreign"] and path.suffix == ".bvh":  # rounded frame times
            self.fps = self.expected["fps"]
        self.armatures = [item for item in bpy.context.scene.objects if item.type == "ARMATURE"]
        self.owner = {bone.name: item for item in self.armatures for bone in item.data.bones}

    def demand(self, truth, text):
        if not truth:
            self.problems.append(text)

    def check_bones(self):
        expected = self.expected
        if expected["foreign"]:
            return
        self.demand(len(self.armatures) == expected["actors"], f"{len(self.armatures)} armatures")
        self.demand(sorted(self.owner) == sorted(expected["joints"]), f"bones are named {sorted(self.owner)}")
        rest = [self.owner[name].matrix_world @ self.owner[name].data.bones[name].head_local
                for name in expected["joints"]]
        error = distance(rest, expected["rest"])
        self.demand(error <= LARGEST_REST_ERROR_M, f"the rest pose is {error:.2e} m off")
        if self.path.suffix == ".fbx":  # glTF's bones are turned to suit Blender, BVH has no frames
            along = [(self.owner[name].matrix_world.to_3x3() @
                      self.owner[name].data.bones[name].matrix_local.to_3x3().col[1]).normalized()
                     for name in expected["joints"]]
            turn = distance(along, expected["rest_y"])
            self.demand(turn <= LARGEST_REST_TURN, f"bones' own y is {turn:.2e} off at rest")

    def check_time(self):
        expected = self.expected
        self.demand(self.path.suffix in (".glb", ".gltf", ".vrm") or
                    abs(self.fps - expected["fps"]) <= 1e-6 * expected["fps"],
                    f"{self.fps} frames per second, not {expected['fps']}")
        actions = [item.animation_data.action for item in self.armatures
                   if item.animation_data is not None and item.animation_data.action is not None]
        if not actions or expected["foreign"]:
            self.demand(expected["duration_s"] == 0.0 or expected["foreign"], "nothing moves")
            return
        name = self.path.stem if self.path.suffix == ".bvh" else expected["name"]
        self.demand(name in actions[0].name, f"the action is named {actions[0].name}")
        first = min(action.frame_range[0] for action in actions)
        last = max(action.frame_range[1] for action in actions)
        if expected["duration_s"] == 0.0:  # Blender calls one key a range of one frame
            self.demand(all(len(curve.keyframe_points) == 1 for curve in actions[0].fcurves), "more than one key")
            last = first
        self.demand(first == self.start, f"it starts in frame {first}")
        duration = (last - first) / self.fps
        # Blender keeps key times as 32-bit floats.
        self.demand(abs(duration - expected["duration_s"]) <= 1e-6 * max(1.0, expected["duration_s"]),
                    f"it lasts {duration} s, not {expected['duration_s']} s")

    def place(self, graph, posed, name, tail=False):
        if name in self.owner:
            bone = posed[self.owner[name].name].pose.bones[name]
            return posed[self.owner[name].name].matrix_world @ (bone.tail if tail else bone.head)
        if self.expected["foreign"] and name.startswith("node"):  # what has no name in the file
            name = "Node_" + name.removeprefix("node")
            if name in self.owner:
                return self.place(graph, posed, name, tail)
        return bpy.context.scene.objects[name].evaluated_get(graph).matrix_world.translation

    def rest_defect(self):
        """How far Blender's own rest matrices are from rotations. It makes them from direction and roll in 32 bits, and
        where a bone points almost against its parent (a leg and the hips) it takes an approximation good to 5e-5."""
        defects = [0.0]
        for name, item in self.owner.items():
            rest = numpy.array(item.data.bones[name].matrix_local.to_3x3())
            defects.append(float(abs(rest.T @ rest - numpy.identity(3)).max()))
        return max(defects)

    def check_samples(self):
        expected = self.expected
        # A joint is within a metre of the bone that turns it wrongly.
        allowance = self.rest_defect() * 1.0
        worst = {"keys": 0.0, "between": 0.0, "vertices": 0.0}
        for sample in expected["samples"]:
            frame = sample["time_s"] * self.fps + self.start
            whole = int(frame + 1e-4)
            fraction = frame - whole
            bpy.context.scene.frame_set(whole, subframe=fraction if fraction > 1e-4 else 0.0)
            graph = bpy.context.evaluated_depsgraph_get()
            posed = {item.name: item.evaluated_get(graph) for item in self.armatures}
            error = distance([self.place(graph, posed, name) for name in expected["joints"]], sample["heads"])
            if sample.get("tails"):
                ends = [self.place(graph, posed, name, True) for name in expected["ends"]]
                error = max(error, distance(ends, sample["tails"]))
            kind = "keys" if sample["bar_m"] < 1e-3 else "between"
            worst[kind] = max(worst[kind], error)
            self.demand(error <= sample["bar_m"] + allowance, f"at {sample['time_s']:.4f} s a joint is {error:.2e} m off")
            for name, vertices in zip(expected["meshes"], sample.get("vertices") or []):
                mesh = bpy.context.scene.objects[name].evaluated_get(graph)
                found = [mesh.matrix_world @ vertex.co for vertex in mesh.data.vertices]
                self.demand(len(found) == len(vertices), f"{len(found)} vertices")
                error = distance(found, vertices)
                worst["vertices"] = max(worst["vertices"], error)
                self.demand(error <= LARGEST_VERTEX_ERROR_M,
                            f"at {sample['time_s']:.4f} s a vertex is {error:.2e} m off")
        return ", ".join(f"{kind} {error:.1e} m" for kind, error in worst.items())


def check(path):
    file = File(path)
    try:
        # A glTF without meshes has no skin, and Blender makes no armature without one.
        if file.path.suffix in (".fbx", ".bvh") or file.expected["meshes"]:
            file.check_bones()
            file.check_time()
        print(f"{path.name}: {file.check_samples()}")
    except Exception as error:  # noqa: BLE001 (the other files are to be looked at too)
        file.problems.append(repr(error))
    for problem in file.problems[:5]:
        print(f"  {path.name}: {problem}")
    return not file.problems


folder, kind = sys.argv[sys.argv.index("--") + 1:]
endings = {"fbx": [".fbx"], "bvh": [".bvh"], "gltf": [".glb", ".gltf", ".vrm"]}[kind]
paths = [path for path in sorted(folder for folder in pathlib.Path(folder).iterdir())
         if path.suffix in endings and pathlib.Path(f"{path}.expected.json").exists()]
assert len(paths) >= 20, f"only {len(paths)} files in {folder}"
bad = [path.name for path in paths if not check(path)]
assert not bad, f"Blender does not find what was written in {len(bad)} of {len(paths)} files: {bad}"
print(f"{len(paths)} files")
