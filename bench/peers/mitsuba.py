# Renders what build/bench/error_time exports with Mitsuba 3 (PyPI), on the processor:
#   python3 mitsuba.py FOLDER
# Its medium has no Lambertian way in and out as nacre's: the body is bounded by nothing, light goes straight through its
# surface. So the picture is another one, with the same medium, geometry, light and camera.
import json
import sys
import time

import numpy

# This script has the module's name: the module must be found first.
sys.path = [path for path in sys.path[1:]]
import mitsuba

mitsuba.set_variant("scalar_rgb")
import drjit
from mitsuba import ScalarTransform4f as Transform

folder = sys.argv[1]
scene_in = json.load(open(folder + "/scene.json"))
job = json.load(open(folder + "/job.json"))


def rgb(values):
    return {"type": "rgb", "value": list(values)}


def write_ply(file, given):
    positions = numpy.fromfile(given["positions"], "<f4").reshape(-1, 3)
    triangles = numpy.fromfile(given["triangles"], "<u4").reshape(-1, 3)
    faces = numpy.empty(len(triangles), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, triangles
    with open(file, "wb") as out:
        out.write(b"ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                  b"property float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n"
                  % (len(positions), len(triangles)))
        out.write(positions.tobytes() + faces.tobytes())


def medium(given):
    """Beer's law and Henyey and Greenstein's phase function, one free path per channel."""
    extinction = [1 / path for path in given["mean_free_path"]]
    return {"type": "homogeneous", "sample_emitters": True, "scale": max(extinction),
            "sigma_t": rgb(value / max(extinction) for value in extinction),  # which must be within 0 and 1
            "albedo": rgb(given["albedo"]),
            "phase": {"type": "hg", "g": given["g"]} if given["g"] else {"type": "isotropic"}}


camera = scene_in["camera"]
scene = {
    "type": "scene",
    # Free paths that depend on the channel need volpathmis.
    "integrator": {"type": "volpathmis", "max_depth": -1, "hide_emitters": True},
    "sensor": {
        "type": "perspective", "fov": camera["fov"], "fov_axis": "y",
        "to_world": Transform().look_at(origin=camera["position"], target=camera["target"], up=camera["up"]),
        "film": {"type": "hdrfilm", "width": scene_in["width"], "height": scene_in["height"], "pixel_format": "rgb",
                 "component_format": "float32", "rfilter": {"type": "box"}},
        "sampler": {"type": "independent"},  # stratified ones round the number of samples
    },
}
if any(scene_in["environment"]):
    scene["environment"] = {"type": "constant", "radiance": rgb(scene_in["environment"])}
for number, rect in enumerate(scene_in["rects"]):
    u, v = numpy.array(rect["u"]) / 2, numpy.array(rect["v"]) / 2
    normal = numpy.cross(u, v)
    matrix = numpy.eye(4)
    matrix[:3] = numpy.stack([u, v, normal / numpy.linalg.norm(normal), rect["center"]], axis=1)
    scene["rect%d" % number] = {"type": "rectangle", "to_world": Transform(matrix),
                                "emitter": {"type": "area", "radiance": rgb(rect["radiance"])}}
for number, given in enumerate(scene_in["objects"]):
    file = "%s/object%d.ply" % (folder, number)
    write_ply(file, given)
    scene["object%d" % number] = {"type": "ply", "filename": file, "face_normals": True, "bsdf": {"type": "null"},
                                  "interior": medium(scene_in["materials"][given["material"]])}

drjit.set_thread_count(job["threads"])
loaded = mitsuba.load_dict(scene)
times = []
for number, render in enumerate(job["renders"]):
    wall, cpu = time.perf_counter(), time.process_time()
    picture = mitsuba.render(loaded, spp=render["spp"], seed=render["seed"])
    times.append({**render, "seconds": time.perf_counter() - wall, "cpu": time.process_time() - cpu,
                  "file": "%s/%d.exr" % (folder, number)})
    mitsuba.Bitmap(picture).write(times[-1]["file"])
json.dump(times, open(folder + "/times.json", "w"))
