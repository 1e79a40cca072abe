# Renders what build/bench/error_time exports with Blender's Cycles (written for 3.4), on the processor:
#   blender -b --factory-startup --python cycles.py -- FOLDER
# FOLDER has scene.json and job.json; pictures and times.json go there.
import array
import json
import math
import sys
import time

import bpy
from mathutils import Matrix, Vector

folder = sys.argv[sys.argv.index("--") + 1]
scene_in = json.load(open(folder + "/scene.json"))
job = json.load(open(folder + "/job.json"))


def numbers(file, kind):
    return array.array(kind, open(file, "rb").read())


def groups(values, size):
    return [values[i:i + size] for i in range(0, len(values), size)]


def frame(x, y, z, origin):
    """The matrix of an object whose axes are x, y, z."""
    rows = [[a, b, c, d] for a, b, c, d in zip(x, y, z, origin)]
    return Matrix(rows + [[0, 0, 0, 1]])


def make_camera(given):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle = math.radians(given["fov"])
    camera.clip_start, camera.clip_end = 1e-3, 1e4
    back = (Vector(given["position"]) - Vector(given["target"])).normalized()  # it looks along -z
    right = Vector(given["up"]).cross(back).normalized()
    item = bpy.data.objects.new("camera", camera)
    item.matrix_world = frame(right, back.cross(right), back, given["position"])
    bpy.context.collection.objects.link(item)
    bpy.context.scene.camera = item


def make_world(radiance, visible):
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    node = world.node_tree.nodes["Background"]
    node.inputs["Color"].default_value = [*radiance, 1]
    node.inputs["Strength"].default_value = 1
    world.cycles_visibility.camera = visible
    bpy.context.scene.world = world


def make_rect(given):
    # A rectangle of power P emits radiance P / (4 area) per channel.
    u, v = Vector(given["u"]), Vector(given["v"])
    lamp = bpy.data.lights.new("rect", "AREA")
    lamp.shape = "RECTANGLE"
    lamp.size, lamp.size_y = v.length, u.length
    lamp.energy = 4 * u.length * v.length * max(given["radiance"])
    lamp.color = [c / max(given["radiance"]) for c in given["radiance"]]
    item = bpy.data.objects.new("rect", lamp)
    # It emits along -z, ours along u x v: x = v, y = u.
    item.matrix_world = frame(v.normalized(), u.normalized(), v.cross(u).normalized(), given["center"])
    item.visible_camera = False
    bpy.context.collection.objects.link(item)


def make_material(given):
    material = bpy.data.materials.new("material")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    color = None
    if "texture" in given:
        texture = nodes.new("ShaderNodeTexImage")
        texture.image = bpy.data.images.load(given["texture"])
        texture.image.colorspace_settings.name = "Linear"
        color = texture.outputs["Color"]

    def set_color(socket, value):
        socket.default_value = [*value, 1]
        if color:
            links.new(color, socket)

    # With a fixed radius the free path is Radius / (4 pi), of the similar isotropic medium: times (1 - g).
    radius = [4 * math.pi * path / (1 - given["g"]) for path in given["mean_free_path"]]
    if given["specular"] == 0 and given["subsurface"]:
        shader = nodes.new("ShaderNodeSubsurfaceScattering")
        shader.falloff = "RANDOM_WALK_FIXED_RADIUS"
        set_color(shader.inputs["Color"], given["subsurface_color"])
        shader.inputs["Scale"].default_value = 1
        shader.inputs["Radius"].default_value = radius
        shader.inputs["Anisotropy"].default_value = given["g"]
        links.new(shader.outputs["BSSRDF"], output.inputs["Surface"])
        return material
    if given["specular"] == 0:
        shader = nodes.new("ShaderNodeBsdfDiffuse")
        set_color(shader.inputs["Color"], given["base_color"])
        links.new(shader.outputs["BSDF"], output.inputs["Surface"])
        return material
    shader = nodes.new("ShaderNodeBsdfPrincipled")
    links.new(shader.outputs["BSDF"], output.inputs["Surface"])
    set_color(shader.inputs["Base Color"], given["base_color"])
    # "Specular" .5 is an index of refraction of 1.5: F0 over .08.
    shader.inputs["Specular"].default_value = ((given["ior"] - 1) / (given["ior"] + 1)) ** 2 / 0.08
    shader.inputs["Roughness"].default_value = given["roughness"]
    if given["subsurface"]:
        shader.subsurface_method = "RANDOM_WALK_FIXED_RADIUS"
        shader.inputs["Subsurface"].default_value = 1
        set_color(shader.inputs["Subsurface Color"], given["subsurface_color"])
        shader.inputs["Subsurface Radius"].default_value = radius
        shader.inputs["Subsurface Anisotropy"].default_value = given["g"]
    return material


def make_object(given, materials):
    positions, corners = numbers(given["positions"], "f"), numbers(given["triangles"], "i")
    count = len(corners) // 3
    mesh = bpy.data.meshes.new("mesh")
    mesh.vertices.add(len(positions) // 3)
    mesh.vertices.foreach_set("co", positions)
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", range(0, len(corners), 3))
    mesh.polygons.foreach_set("loop_total", [3] * count)
    if "uvs" in given:
        uvs = groups(numbers(given["uvs"], "f"), 2)
        mesh.uv_layers.new().data.foreach_set("uv", [x for corner in corners for x in uvs[corner]])
    mesh.update()
    if "normals" in given:
        mesh.polygons.foreach_set("use_smooth", [True] * count)
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set_from_vertices(groups(numbers(given["normals"], "f"), 3))
    mesh.materials.append(materials[given["material"]])
    bpy.context.collection.objects.link(bpy.data.objects.new("object", mesh))


def settings():
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = scene_in["width"], scene_in["height"]
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", job["threads"]
    scene.render.use_persistent_data = True
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.color_depth = "32"
    scene.render.film_transparent = False
    cycles = scene.cycles
    cycles.device = "CPU"
    # Nothing that stops early, smooths, or leaves out light.
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.use_auto_tile = False
    cycles.time_limit = 0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.light_sampling_threshold = cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = scene_in["max_depth"]


for item in list(bpy.data.objects):
    bpy.data.objects.remove(item)
settings()
make_camera(scene_in["camera"])
make_world(scene_in["environment"], scene_in["environment_visible"])
for rect in scene_in["rects"]:
    make_rect(rect)
made = [make_material(given) for given in scene_in["materials"]]
for given in scene_in["objects"]:
    make_object(given, made)

times = []
for number, render in enumerate(job["renders"]):
    scene = bpy.context.scene
    scene.cycles.samples, scene.cycles.seed = render["spp"], render["seed"]
    scene.render.filepath = "%s/%d.exr" % (folder, number)
    wall, cpu = time.perf_counter(), time.process_time()
    bpy.ops.render.render(write_still=True)
    times.append({**render, "seconds": time.perf_counter() - wall, "cpu": time.process_time() - cpu,
                  "file": scene.render.filepath})
json.dump(times, open(folder + "/times.json", "w"))
