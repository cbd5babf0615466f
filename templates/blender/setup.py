# {{title}}
# Brings {{glb}} into Blender as mien plays it. Run it in Blender's Scripting tab, or: blender --python {{script}}
import os

import bpy
import numpy

FILE = {{glb_string}}
FPS = {{fps}}
LAST_FRAME = {{last_frame}}

if not hasattr(numpy, "bool"):  # Blender 3.4's importer asks for a name that newer NumPy has dropped
    numpy.bool = bool

folder = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else bpy.path.abspath("//")
scene = bpy.context.scene
scene.render.fps = FPS  # before the import: it turns seconds into frames
scene.render.fps_base = 1
scene.frame_start, scene.frame_end = 0, LAST_FRAME
bpy.ops.import_scene.gltf(filepath=os.path.join(folder, FILE))

# Blender leaves an empty with the name of each skinned mesh that plays, and calls the mesh NAME.001.
for empty in [thing for thing in bpy.context.selected_objects if thing.type == "EMPTY"]:
    mesh = bpy.data.objects.get(empty.name + ".001")
    if mesh is not None and mesh.type == "MESH" and not empty.children:
        name = empty.name
        bpy.data.objects.remove(empty)
        mesh.name = name

# The joints are in the way of the face.
for thing in bpy.context.selected_objects:
    if thing.type == "ARMATURE":
        thing.hide_set(True)
scene.frame_set(0)
print("mien: %d objects; targets are shape keys of 'skin', from 0 to 1" % len(bpy.context.selected_objects))
