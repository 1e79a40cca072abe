#include "scaling/cost.h"
#include "measure.h"
#include "meshes.h"
#include "render/session.h"
#include "walks/walk_scene.h"

namespace nacre::bench {

double seconds_per_sample(const device::Device &device, const Setting &setting, int runs) {
    const int side = std::max(2, int(std::lround(std::sqrt(setting.triangles / 12))));
    scene::Scene scene = walk_scene(make_blob(side), setting.mean_free_path, 0);
    scene.camera.position = {1.5, 1.2, 3.8};
    scene.image = {setting.pixels, setting.pixels};
    scene.render.max_depth = 8;
    render::Session session(device, scene, {});
    session.render(setting.samples); // PoCL generates code, launches find their size
    std::vector<double> seconds;
    double before = session.statistics().sampling;
    for (int run = 0; run < runs; run++) {
        session.render(setting.samples);
        const double after = session.statistics().sampling;
        seconds.push_back(after - before);
        before = after;
    }
    return median(seconds) / (double(setting.pixels) * setting.pixels * setting.samples);
}

} // namespace nacre::bench
