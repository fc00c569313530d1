# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the scenes of this folder with Blender:  blender --background --python make_scenes.py

A tube with a skin on two bones and a shape key, a box that turns by itself, and a lid that a bone carries; 9 frames at
24 per second. `worm-fbx.txt` and `worm-dae.txt` hold where Blender itself puts every vertex in every frame.

Blender's Collada has no shape keys, writes armatures right only where they have no transform of their own, and forgets
the length of a bone that carries something: there the scene does without.
"""
import math
import os

import bpy

HERE = os.path.dirname(os.path.abspath(__file__))
FRAMES = 9
SIDES, RINGS = 6, 5


def mesh_object(name, vertices, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    mesh.update()
    result = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(result)
    return result


def tube(name):
    vertices = [(math.cos(2 * math.pi * s / SIDES) * 0.5, math.sin(2 * math.pi * s / SIDES) * 0.5, 0.5 * r)
                for r in range(RINGS) for s in range(SIDES)]
    faces = [(r * SIDES + s, r * SIDES + (s + 1) % SIDES, (r + 1) * SIDES + (s + 1) % SIDES, (r + 1) * SIDES + s)
             for r in range(RINGS - 1) for s in range(SIDES)]
    return mesh_object(name, vertices, faces)


def box(name, size):
    x, y, z = size
    vertices = [(x * i, y * j, z * k) for k in (0, 1) for j in (0, 1) for i in (0, 1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return mesh_object(name, vertices, faces)


def skeleton():
    armature = bpy.data.armatures.new('bones')
    result = bpy.data.objects.new('bones', armature)
    bpy.context.collection.objects.link(result)
    bpy.context.view_layer.objects.active = result
    bpy.ops.object.mode_set(mode='EDIT')
    lower = armature.edit_bones.new('lower')
    lower.head, lower.tail = (0, 0, 0), (0, 0, 1)
    upper = armature.edit_bones.new('upper')
    upper.head, upper.tail = (0, 0, 1), (0, 0, 2)
    upper.parent = lower
    bpy.ops.object.mode_set(mode='OBJECT')
    return result


def build(for_collada):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps = 24
    scene.frame_start, scene.frame_end = 1, FRAMES

    bones = skeleton()
    if not for_collada:
        bones.location = (2, -1, 0.5)
        bones.rotation_euler = (0, 0.3, 0.5)
    worm = tube('worm')
    worm.parent = bones
    worm.modifiers.new('skin', 'ARMATURE').object = bones
    for name in ('lower', 'upper'):
        worm.vertex_groups.new(name=name)
    for v in worm.data.vertices:
        share = min(1.0, max(0.0, v.co.z - 0.5))
        worm.vertex_groups['lower'].add([v.index], 1 - share, 'REPLACE')
        worm.vertex_groups['upper'].add([v.index], share, 'REPLACE')
    if not for_collada:
        worm.shape_key_add(name='Basis')
        fat = worm.shape_key_add(name='fat')
        for i, v in enumerate(worm.data.vertices):
            fat.data[i].co = (v.co.x * 2, v.co.y * 1.5, v.co.z)

    crate = box('crate', (1, 2, 3))
    crate.location = (-3, 0, 0)
    crate.scale = (0.5, 0.5, 0.25)
    lid = box('lid', (0.5, 0.25, 0.125))
    if for_collada:
        lid.parent = crate
        lid.location = (0, 0, 3)
    else:
        lid.parent, lid.parent_type, lid.parent_bone = bones, 'BONE', 'upper'

    for frame in range(1, FRAMES + 1):
        t = (frame - 1) / (FRAMES - 1)
        pose = bones.pose.bones['upper']
        pose.rotation_mode = 'QUATERNION'
        pose.rotation_quaternion = (math.cos(t * 0.6), math.sin(t * 0.6), 0, 0)
        pose.keyframe_insert('rotation_quaternion', frame=frame)
        bones.pose.bones['lower'].location = (0, 0.25 * t, 0)
        bones.pose.bones['lower'].keyframe_insert('location', frame=frame)
        crate.rotation_euler = (0, 0, 2 * t)
        crate.keyframe_insert('rotation_euler', frame=frame)
        if not for_collada:
            fat.value = t * t
            fat.keyframe_insert('value', frame=frame)
    return [crate, lid, worm]


def write_truth(objects, name):
    scene = bpy.context.scene
    with open(os.path.join(HERE, name), 'w') as out:
        out.write(f'{FRAMES} {sum(len(o.data.vertices) for o in objects)}\n')
        for frame in range(1, FRAMES + 1):
            scene.frame_set(frame)
            graph = bpy.context.evaluated_depsgraph_get()
            for o in objects:
                moved = o.evaluated_get(graph)
                for v in moved.to_mesh().vertices:
                    p = moved.matrix_world @ v.co
                    out.write(f'{p.x:.7g} {p.y:.7g} {p.z:.7g}\n')
                moved.to_mesh_clear()


write_truth(build(for_collada=False), 'worm-fbx.txt')
bpy.ops.export_scene.fbx(filepath=os.path.join(HERE, 'worm.fbx'), bake_anim_step=1, bake_anim_simplify_factor=0,
                         bake_anim_use_all_actions=False, bake_anim_use_nla_strips=False, add_leaf_bones=False)
write_truth(build(for_collada=True), 'worm-dae.txt')
bpy.ops.wm.collada_export(filepath=os.path.join(HERE, 'worm.dae'))
