#include "albedo/inversion.h"
#include "albedo/half_space.h"
#include "albedo/memo.h"
#include "albedo/table.h"
#include <algorithm>
#include <cmath>

namespace nacre::albedo {
namespace {

using namespace shared;

/// OpenPBR 1.1, section "Subsurface".
double van_de_hulst(double x, double g) {
    const double s = 4.09712 + 4.20863 * x - std::sqrt(9.59217 + 41.6808 * x + 17.7126 * x * x);
    return albedo_of(std::clamp(s, 0.0, 1.0), g);
}

/// Chiang, Kutz & Burley 2016, "Practical and Controllable Subsurface Scattering for Production Path Tracing".
double chiang(double x) { return 1 - std::exp(-5.09406 * x + 2.61188 * x * x - 4.31805 * x * x * x); }

} // namespace

double albedo(Inversion inversion, double color, const Medium &medium) {
    const double x = std::clamp(color, 0.0, 1.0), g = medium.anisotropy;
    if (inversion == INVERSION_NONE || x == 0 || x == 1) return x;
    double found = x;
    switch (inversion) {
    case INVERSION_TABLE:
        found = albedo_of(table_similarity(built_in_table(), x, g, medium.bleed, medium.flight, medium.entry), g);
        break;
    case INVERSION_MEMO: found = memo_albedo(uncapped_fit, x, std::clamp(g, 0.0, 0.95)); break;
    case INVERSION_VAN_DE_HULST: found = van_de_hulst(x, g); break;
    case INVERSION_CHIANG: found = chiang(x); break;
    case INVERSION_NONE: break;
    }
    return std::clamp(found, 0.0, 1.0);
}

} // namespace nacre::albedo
