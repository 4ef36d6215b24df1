"""Blender must find in our FBX files what FILE.json beside each says: one armature with the right names, rest pose,
frame rate and duration, joints where they are at keys and between them, and vertices that follow.

Usage: blender -b --factory-startup --python-exit-code 1 --python check_fbx.py -- FOLDER
"""
import json
import pathlib
import sys

import bpy
import numpy

# Blender 3.4's importer takes the rounded frame rate when it places keys: at 29.97 frames a second they would come in
# frames of 30 a second.
import io_scene_fbx.import_fbx as import_fbx  # noqa: E402

place_keys = import_fbx.blen_read_animations_action_item
import_fbx.blen_read_animations_action_item = lambda action, item, curves, fps, *rest: place_keys(
    action, item, curves, fps / bpy.context.scene.render.fps_base, *rest)

LARGEST_VERTEX_ERROR_M = 1e-3
LARGEST_REST_ERROR_M = 1e-5


def distance(found, expected):
    return float(numpy.abs(numpy.linalg.norm(numpy.array(found) - numpy.array(expected), axis=-1)).max())


def check(path):
    expected = json.loads(path.with_suffix(".json").read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.fbx(filepath=str(path))
    scene = bpy.context.scene
    armatures = [item for item in scene.objects if item.type == "ARMATURE"]
    problems = []

    def demand(truth, text):
        if not truth:
            problems.append(text)

    demand(len(armatures) == expected["armatures"], f"{len(armatures)} armatures")
    owner = {bone.name: item for item in armatures for bone in item.data.bones}
    names = list(owner)
    demand(sorted(names) == sorted(expected["joints"]), f"bones are named {names}")
    fps = scene.render.fps / scene.render.fps_base
    demand(abs(fps - expected["fps"]) < 1e-6 * expected["fps"], f"{fps} frames per second, not {expected['fps']}")
    action = owner[expected["joints"][0]].animation_data.action
    demand(expected["name"] in action.name, f"the action is named {action.name}")
    first, last = action.frame_range
    if expected["duration_s"] == 0.0:  # Blender calls one key a range of one frame
        demand(all(len(curve.keyframe_points) == 1 for curve in action.fcurves), "there is more than one key")
        last = first
    duration = (last - first) / fps
    # Blender keeps key times as 32-bit floats.
    demand(abs(duration - expected["duration_s"]) <= 1e-6 * max(1.0, expected["duration_s"]),
           f"it lasts {duration} s, not {expected['duration_s']} s")

    rest = [owner[name].matrix_world @ owner[name].data.bones[name].head_local for name in expected["joints"]]
    rest_error = distance(rest, expected["rest"])
    demand(rest_error <= LARGEST_REST_ERROR_M, f"the rest pose is {rest_error:.2e} m off")

    meshes = [item for item in scene.objects if item.type == "MESH"]
    at_keys = between = at_vertices = 0.0
    for sample in expected["samples"]:
        frame = sample["time_s"] * expected["fps"] + 1.0
        whole = int(frame + 1e-6)
        scene.frame_set(whole, subframe=max(0.0, frame - whole))
        graph = bpy.context.evaluated_depsgraph_get()
        posed = {item.name: item.evaluated_get(graph) for item in armatures}
        heads = [posed[owner[name].name].matrix_world @ posed[owner[name].name].pose.bones[name].head
                 for name in expected["joints"]]
        error = distance(heads, sample["heads"])
        demand(error <= sample["bar_m"], f"at {sample['time_s']:.4f} s a joint is {error:.2e} m off")
        if sample["bar_m"] > 1e-4:
            between = max(between, error)
        else:
            at_keys = max(at_keys, error)
        if "vertices" in sample:
            demand(len(meshes) == 1, f"{len(meshes)} meshes")
            mesh = meshes[0].evaluated_get(graph)
            found = [mesh.matrix_world @ vertex.co for vertex in mesh.data.vertices]
            demand(len(found) == len(sample["vertices"]), f"{len(found)} vertices")
            error = distance(found, sample["vertices"])
            at_vertices = max(at_vertices, error)
            demand(error <= LARGEST_VERTEX_ERROR_M, f"at {sample['time_s']:.4f} s a vertex is {error:.2e} m off")
    print(f"{path.name}: rest {rest_error:.1e} m, keys {at_keys:.1e} m, between {between:.1e} m, "
          f"vertices {at_vertices:.1e} m")
    for problem in problems[:5]:
        print(f"  {path.name}: {problem}")
    return not problems


folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
paths = sorted(folder.glob("*.fbx"))
assert len(paths) >= 5, f"no FBX files in {folder}"
bad = [path.name for path in paths if not check(path)]
assert not bad, f"Blender does not find what was written in {bad}"
