# How many heads a second Blender's shape keys deform, to hold mien's rate against: a skin of as many vertices and
# triangles, a shape key a move, all of them moving, vertex normals included; one thread.
#   blender -b -t 1 --factory-startup -P blender_shape_keys.py -- VERTICES KEYS
import random
import sys
import time

import bpy

vertices, keys = (int(word) for word in sys.argv[sys.argv.index("--") + 1:])
width = int(vertices**0.5)
rows = vertices // width
triangles = []
for y in range(rows - 1):
    for x in range(width - 1):
        at = y * width + x
        triangles += [(at, at + 1, at + width), (at + 1, at + width + 1, at + width)]
rest = [(x * 0.001, y * 0.001, 0.0) for y in range(rows) for x in range(width)]

mesh = bpy.data.meshes.new("skin")
mesh.from_pydata(rest, [], triangles)
skin = bpy.data.objects.new("skin", mesh)
bpy.context.collection.objects.link(skin)
skin.shape_key_add(name="rest")
draw = random.Random(1)
for key in range(keys):
    moved = skin.shape_key_add(name=str(key))
    flat = [number + draw.uniform(-0.01, 0.01) for point in rest for number in point]
    moved.data.foreach_set("co", flat)
blocks = mesh.shape_keys.key_blocks[1:]

count, used = 0, 0.0
while used < 4:
    for block in blocks:
        block.value = draw.random()
    start = time.process_time()
    bpy.context.view_layer.update()
    deformed = skin.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    deformed.calc_normals()
    assert len(deformed.vertices) == len(rest)
    used += time.process_time() - start
    count += 1
print(f"heads {count / used:.1f}")
