"""Blender must put every joint and bone end of our BVH files where we say it is, at every key.

Usage: blender -b --factory-startup --python-exit-code 1 --python check_bvh.py -- FOLDER
Every FILE.bvh has a FILE.json with fps, metres_per_unit, joints and heads[frame][joint] (Blender's
world, metres), and the same for the ends of the last bones: ends and tails[frame][end].
"""
import builtins
import json
import pathlib
import sys

import bpy
import numpy

LARGEST_ERROR_M = 1e-4

# Blender 3.4's importer opens files in a mode and uses a name of numpy that Debian's Python and numpy no longer have.
if not hasattr(numpy, "bool"):
    numpy.bool = bool
import io_anim_bvh.import_bvh as import_bvh  # noqa: E402 (after the patch)

import_bvh.open = lambda path, mode="r", **options: builtins.open(path, mode.replace("U", ""), **options)


def largest_error(path, rotate_mode):
    expected = json.loads(path.with_suffix(".json").read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_anim.bvh(filepath=str(path), global_scale=expected["metres_per_unit"], update_scene_fps=True,
                            rotate_mode=rotate_mode)
    scene = bpy.context.scene
    armature = bpy.context.object
    fps = scene.render.fps / scene.render.fps_base
    assert abs(fps - expected["fps"]) < 1e-3 * expected["fps"], f"{path.name}: {fps} frames per second"
    assert len(armature.pose.bones) == len(expected["joints"]), f"{path.name}: {len(armature.pose.bones)} bones"
    frames = len(expected["heads"])
    last = armature.animation_data.action.frame_range[1]
    assert last == frames, f"{path.name}: the last key is in frame {last} instead of {frames}"
    worst = 0.0
    assert expected["ends"], f"{path.name}: no last bones to check"
    for frame, (heads, tails) in enumerate(zip(expected["heads"], expected["tails"])):
        scene.frame_set(frame + 1)
        evaluated = armature.evaluated_get(bpy.context.evaluated_depsgraph_get())
        bones = evaluated.pose.bones
        pairs = [(bones[name].head, p) for name, p in zip(expected["joints"], heads)]
        pairs += [(bones[name].tail, p) for name, p in zip(expected["ends"], tails)]
        for found, p in pairs:
            worst = max(worst, float(numpy.linalg.norm(numpy.array(evaluated.matrix_world @ found) - numpy.array(p))))
    return worst


def check(path):
    # By default Blender turns the angles into Euler angles of the bone's own axes, in single precision, and loses up to
    # a few 1e-4 rad near *their* gimbal lock. So the bar is for its quaternions; the default's error is only shown.
    worst = largest_error(path, "QUATERNION")
    print(f"{path.name}: largest error {worst:.2e} m (as Euler angles {largest_error(path, 'NATIVE'):.2e} m)")
    return worst


folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
paths = sorted(folder.glob("*.bvh"))
assert len(paths) >= 2, f"no BVH files in {folder}"
bad = [path.name for path in paths if not check(path) <= LARGEST_ERROR_M]
assert not bad, f"joints are more than {LARGEST_ERROR_M} m off in {bad}"
