#include "albedo/memo.h"
#include <cmath>

namespace nacre::albedo {
namespace {

double value(const Polynomial &p, double g) {
    double sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * g + p[i];
    return sum;
}

double value(const ExponentialOfPolynomial &p, double g) {
    double sum = 0;
    for (std::size_t i = p.power.size(); i-- > 0;) sum = (sum + p.power[i]) * g;
    return p.offset + p.factor * std::exp(sum);
}

} // namespace

double memo_albedo(const MemoFit &fit, double x, double g) {
    const double blend = std::pow(x, 0.25);
    return (1 - blend) * value(fit.a, g) * std::pow(std::atan(value(fit.b, g) * x), value(fit.c, g)) +
           blend * value(fit.d, g) * std::pow(std::atan(value(fit.e, g) * x), value(fit.f, g));
}

const MemoFit uncapped_fit = {};

const MemoFit published_fit = {
    {1.8260523782, -1.28451056436, -1.79904629312, 9.19393289202, -22.8215585862, 32.0234874259, -23.6264803333,
     7.21067002658},
    {4.98511194385,
     0.127355959438,
     {31.1491581433, -201.847017512, 841.576016723, -2018.09288505, 2731.71560286, -1935.41424244, 559.009054474}},
    {1.09686102424, -0.394704063468, 1.05258115941, -8.83963712726, 28.8643230661, -46.8802913581, 38.5402837518,
     -12.7181042538},
    {0.496310210422, 0.360146581622, -2.15139309747, 17.8896899217, -55.2984010333, 82.065982243, -58.5106008578,
     15.8478295021},
    {4.23190299701,
     0.00310603949088,
     {76.7316253952, -594.356773233, 2448.8834203, -5576.68528998, 7116.60171912, -4763.54467887, 1303.5318055}},
    {2.40602999408, -2.51814844609, 9.18494908356, -79.2191708682, 259.082868209, -403.613804597, 302.85712436,
     -87.4370473567}};

} // namespace nacre::albedo
