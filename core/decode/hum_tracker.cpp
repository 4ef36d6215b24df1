#include "decode/hum_tracker.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::decode {
namespace {

constexpr double kMemory = 45.0;  // cycles
constexpr double kKept = 1.0 - 1.0 / kMemory;
constexpr double kPhaseMemory = 15.0;     // cycles
constexpr double kTuning = 1.0 / 90.0;    // of what the phase drifts by, per cycle: settles in three seconds
constexpr double kLargestRate = 0.02;     // radians per cycle: 0.2 Hz
constexpr double kLargestDetuning = 0.2;  // Hz
constexpr int kFitEvery = 6;              // cycles
constexpr double kEnough = 24.0;          // steps, before anything is told
constexpr double kStandsOut = 5.0;        // standard deviations of an amplitude
constexpr double kLeast = 2e-5;           // of full scale: less does no harm
constexpr double kBetter = 1.2;           // by which the other mains must explain more to be believed instead

}  // namespace

HumTracker::Vector HumTracker::waves(const Mains& mains, double samples) const {
  Vector waves = Vector::Zero();
  const double turns = mains.turns + mains.hz * samples / rate_.hz;
  const double c = std::cos(2.0 * kPi * turns);
  const double d = std::sin(2.0 * kPi * turns);
  waves[1] = c;
  waves[2] = d;
  for (int k = 2; k <= kHarmonics; ++k) {
    waves[2 * k - 1] = waves[2 * k - 3] * c - waves[2 * k - 2] * d;
    waves[2 * k] = waves[2 * k - 3] * d + waves[2 * k - 2] * c;
  }
  return waves;
}

void HumTracker::fit(Mains& mains) const {
  mains.found.setZero();
  mains.explained = 0.0;
  // A little of the identity: where two harmonics fall on the same frequency neither is told.
  const Matrix normal = mains.normal + 1e-3 * weight_ * Matrix::Identity();
  const Eigen::LDLT<Matrix> factors(normal);
  const Vector solution = factors.solve(mains.right);
  const double rest = std::max(0.0, square_ - solution.dot(mains.right));
  const double variance = rest / (weight_ - kUnknowns);
  // A diagonal element of the inverse is at least the inverse of that element: most lines need no more than this.
  const bool any = [&] {
    for (int k = 1; k <= kHarmonics; ++k) {
      const double least = variance / std::min(normal(2 * k - 1, 2 * k - 1), normal(2 * k, 2 * k));
      const double square = solution.segment<2>(2 * k - 1).squaredNorm();
      if (square > std::max(kStandsOut * kStandsOut * least, kLeast * kLeast)) {
        return true;
      }
    }
    return false;
  }();
  if (!any) {
    return;
  }
  const Matrix inverse = factors.solve(Matrix::Identity());
  for (int k = 1; k <= kHarmonics; ++k) {
    const int c = 2 * k - 1;
    const int s = 2 * k;
    const double amplitude = std::hypot(solution[c], solution[s]);
    const double sd = std::sqrt(variance * std::max(inverse(c, c), inverse(s, s)));
    if (amplitude > std::max(kStandsOut * sd, kLeast)) {
      mains.found[c] = solution[c];
      mains.found[s] = solution[s];
      mains.explained += solution[c] * mains.right[c] + solution[s] * mains.right[s];
    }
  }
}

// What was fitted is the hum of a memory's length ago.
void HumTracker::follow_phase(Mains& mains, double cycles, double cycle_hz) {
  int strongest = 0;
  double largest = 0.0;
  for (int k = 1; k <= kHarmonics; ++k) {
    const double amplitude = std::hypot(mains.found[2 * k - 1], mains.found[2 * k]);
    if (amplitude > largest) {
      largest = amplitude;
      strongest = k;
    }
  }
  if (strongest == 0) {
    mains.strongest = 0;
    mains.phase_rate = 0.0;
    return;
  }
  const double phase = std::atan2(mains.found[2 * strongest], mains.found[2 * strongest - 1]);
  if (strongest == mains.strongest) {
    const double change = std::remainder(phase - mains.phase, 2.0 * kPi) / (strongest * cycles);
    mains.phase_rate +=
        (std::clamp(change, -kLargestRate, kLargestRate) - mains.phase_rate) * std::min(1.0, cycles / kPhaseMemory);
    // A phase that falls behind: the hum is faster.
    mains.hz = std::clamp(mains.hz - kTuning * cycles * mains.phase_rate * cycle_hz / (2.0 * kPi),
                          mains.nominal_hz - kLargestDetuning, mains.nominal_hz + kLargestDetuning);
  }
  mains.strongest = strongest;
  mains.phase = phase;
  for (int k = 1; k <= kHarmonics; ++k) {
    const Eigen::Rotation2Dd turn(k * mains.phase_rate * (kMemory - 1.0));
    mains.found.segment<2>(2 * k - 1) = turn * mains.found.segment<2>(2 * k - 1).eval();
  }
}

void HumTracker::step(CycleMeasurement& cycle, int slots, double kappa, bool usable) {
  const auto last = static_cast<std::size_t>(slots - 1);
  const LevelReading reference = cycle.slots[last];
  const bool whole = usable && cycle.broken == 0;
  std::array<Vector, 2> before;
  for (std::size_t i = 0; i < mains_.size(); ++i) {
    Mains& mains = mains_[i];
    before[i] = mains.at_reference;
    mains.turns = std::fmod(mains.turns + mains.hz * (reference.centre - instant_) / rate_.hz, 1.0);
    mains.at_reference = waves(mains, 0.0);
  }
  if (whole && linked_ && cycle.linked) {
    const double step = reference.mean - level_ + kappa * reference.integral;
    weight_ = kKept * weight_ + 1.0;
    square_ = kKept * square_ + step * step;
    for (std::size_t i = 0; i < mains_.size(); ++i) {
      Mains& mains = mains_[i];
      Vector change = mains.at_reference - before[i];
      change[0] = 1.0;
      mains.normal = kKept * mains.normal + change * change.transpose();
      mains.right = kKept * mains.right + step * change;
    }
  }
  if (++since_fit_ >= kFitEvery && weight_ > kEnough && whole) {
    for (Mains& mains : mains_) {
      fit(mains);
      follow_phase(mains, since_fit_, rate_.hz / cycle.period());
    }
    since_fit_ = 0;
    const int better = mains_[1].explained > mains_[0].explained ? 1 : 0;
    if (mains_[static_cast<std::size_t>(better)].explained <= 0.0) {
      believed_ = -1;
    } else if (believed_ < 0 || mains_[static_cast<std::size_t>(better)].explained >
                                    kBetter * mains_[static_cast<std::size_t>(believed_)].explained) {
      believed_ = better;
    }
  }
  linked_ = whole;
  level_ = reference.mean;
  instant_ = reference.centre;
  if (believed_ >= 0) {
    const Mains& mains = mains_[static_cast<std::size_t>(believed_)];
    for (std::size_t j = 0; j <= last; ++j) {
      cycle.slots[j].mean -= mains.found.dot(waves(mains, cycle.slots[j].centre - reference.centre));
    }
  }
}

double HumTracker::amplitude() const {
  return believed_ < 0 ? 0.0 : mains_[static_cast<std::size_t>(believed_)].found.norm();
}

double HumTracker::mains_hz() const {
  return believed_ < 0 ? 0.0 : mains_[static_cast<std::size_t>(believed_)].nominal_hz;
}

}  // namespace limbwave::decode
