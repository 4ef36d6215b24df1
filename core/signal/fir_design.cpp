#include "signal/fir_design.h"

#include <cassert>
#include <cmath>
#include <cstring>

#include "base/units.h"

namespace limbwave::signal {
namespace {

using Vector4 = float __attribute__((vector_size(16)));

Vector4 load(const float* p) {
  Vector4 v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

float sum(Vector4 a, Vector4 b) {
  const Vector4 s = a + b;
  return (s[0] + s[1]) + (s[2] + s[3]);
}

// Modified Bessel function of order zero.
double bessel_i0(double x) {
  double term = 1.0;
  double total = 1.0;
  for (int k = 1; k < 60 && term > 1e-18 * total; ++k) {
    term *= (0.5 * x / k) * (0.5 * x / k);
    total += term;
  }
  return total;
}

double kaiser_beta(double attenuation_db) {
  if (attenuation_db > 50.0) {
    return 0.1102 * (attenuation_db - 8.7);
  }
  return attenuation_db > 21.0 ? 0.5842 * std::pow(attenuation_db - 21.0, 0.4) + 0.07886 * (attenuation_db - 21.0)
                               : 0.0;
}

}  // namespace

std::size_t kaiser_taps(double width, double attenuation_db) {
  return static_cast<std::size_t>(std::ceil((attenuation_db - 7.95) / (14.36 * width))) + 1;
}

std::vector<double> low_pass(std::size_t taps, double cutoff, double attenuation_db) {
  assert(taps > 0);
  const double beta = kaiser_beta(attenuation_db);
  const double middle = 0.5 * static_cast<double>(taps - 1);
  std::vector<double> h(taps);
  double total = 0.0;
  for (std::size_t n = 0; n < taps; ++n) {
    const double t = static_cast<double>(n) - middle;
    const double sinc = t == 0.0 ? 2.0 * cutoff : std::sin(2.0 * kPi * cutoff * t) / (kPi * t);
    const double u = middle > 0.0 ? t / middle : 0.0;
    h[n] = sinc * bessel_i0(beta * std::sqrt(std::max(0.0, 1.0 - u * u))) / bessel_i0(beta);
    total += h[n];
  }
  for (double& tap : h) {
    tap /= total;
  }
  return h;
}

std::vector<double> band_pass(std::size_t taps, double center, double half_width, double attenuation_db) {
  std::vector<double> h = low_pass(taps, half_width, attenuation_db);
  const double middle = 0.5 * static_cast<double>(taps - 1);
  for (std::size_t n = 0; n < taps; ++n) {
    h[n] *= 2.0 * std::cos(2.0 * kPi * center * (static_cast<double>(n) - middle));
  }
  return h;
}

float dot(const float* a, const float* b, std::size_t count) {
  assert(count % kDotMultiple == 0);
  Vector4 s0{};
  Vector4 s1{};
  for (std::size_t i = 0; i < count; i += kDotMultiple) {
    s0 += load(a + i) * load(b + i);
    s1 += load(a + i + 4) * load(b + i + 4);
  }
  return sum(s0, s1);
}

DotPair dot_pair(const float* x, const float* taps_first, const float* taps_second, std::size_t count) {
  assert(count % kDotMultiple == 0);
  Vector4 a0{};
  Vector4 a1{};
  Vector4 b0{};
  Vector4 b1{};
  for (std::size_t i = 0; i < count; i += kDotMultiple) {
    const Vector4 x0 = load(x + i);
    const Vector4 x1 = load(x + i + 4);
    a0 += x0 * load(taps_first + i);
    a1 += x1 * load(taps_first + i + 4);
    b0 += x0 * load(taps_second + i);
    b1 += x1 * load(taps_second + i + 4);
  }
  return {sum(a0, a1), sum(b0, b1)};
}

SymmetricFir::SymmetricFir(const std::vector<float>& taps) {
  assert(taps.size() % 2 == 1);
  const std::size_t middle = taps.size() / 2;
  for (std::size_t k = 0; k <= middle; ++k) {
    assert(std::abs(taps[middle + k] - taps[middle - k]) <= 1e-6F);
    half_.push_back(taps[middle + k]);
  }
}

void SymmetricFir::run(const float* x, std::size_t count, float* out) const {
  const std::size_t middle = half_.size() - 1;
  const float* half = half_.data();
  std::size_t i = 0;
  for (; i + 16 <= count; i += 16) {
    const float* center = x + i + middle;
    Vector4 s0 = load(center) * half[0];
    Vector4 s1 = load(center + 4) * half[0];
    Vector4 s2 = load(center + 8) * half[0];
    Vector4 s3 = load(center + 12) * half[0];
    for (std::size_t k = 1; k <= middle; ++k) {
      const float* before = center - k;
      const float* after = center + k;
      s0 += (load(before) + load(after)) * half[k];
      s1 += (load(before + 4) + load(after + 4)) * half[k];
      s2 += (load(before + 8) + load(after + 8)) * half[k];
      s3 += (load(before + 12) + load(after + 12)) * half[k];
    }
    std::memcpy(out + i, &s0, sizeof s0);
    std::memcpy(out + i + 4, &s1, sizeof s1);
    std::memcpy(out + i + 8, &s2, sizeof s2);
    std::memcpy(out + i + 12, &s3, sizeof s3);
  }
  for (; i < count; ++i) {
    const float* center = x + i + middle;
    float s = *center * half[0];
    for (std::size_t k = 1; k <= middle; ++k) {
      s += (*(center - k) + *(center + k)) * half[k];
    }
    out[i] = s;
  }
}

}  // namespace limbwave::signal
