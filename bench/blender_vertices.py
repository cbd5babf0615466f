# How far the vertices of the face that Blender has open are from where they should be: prints one line of JSON.
#   blender -b --factory-startup -P face.py -P blender_vertices.py -- MOMENTS.json [BACK.glb]
# BACK.glb: where Blender's own exporter writes the face again, sampled frame by frame.
# MOMENTS.json: {"moments": [seconds], "truths": [{part: [[x, y, z] in mm]}]}.
import json
import sys

import bpy

words = sys.argv[sys.argv.index("--") + 1 :]
asked = json.load(open(words[0]))
scene = bpy.context.scene
told = {"worst_mm": 0, "part": "", "at": 0, "parts": 0}
for at, truth in zip(asked["moments"], asked["truths"]):
    frame = at * scene.render.fps
    scene.frame_set(int(frame), subframe=frame - int(frame))
    graph = bpy.context.evaluated_depsgraph_get()
    parts = set()
    for thing in scene.objects:
        if thing.type != "MESH" or thing.name not in truth:
            continue
        shown = thing.evaluated_get(graph)
        mesh = shown.to_mesh()
        # Where the skin is cut its vertices are there twice: those that come again stand behind the others. Parts of
        # sharp borders have more of them in between, and are left out.
        if len(mesh.vertices) != len(truth[thing.name]) and thing.name != "skin":
            continue
        parts.add(thing.name)
        for vertex, place in zip(mesh.vertices, truth[thing.name]):
            x, y, z = (1000 * number for number in shown.matrix_world @ vertex.co)
            off = ((x - place[0]) ** 2 + (z - place[1]) ** 2 + (-y - place[2]) ** 2) ** 0.5
            if off > told["worst_mm"]:
                told.update(worst_mm=off, part=thing.name, at=at)
        shown.to_mesh_clear()
    told["parts"] = len(parts)
print(json.dumps(told))
if len(words) > 1:
    bpy.ops.export_scene.gltf(filepath=words[1], export_format="GLB", export_morph=True, export_animations=True)
