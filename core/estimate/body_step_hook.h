/// What is done around the steps of a body filter, by whoever runs it over a recording: forward, and again forward from
/// a snapshot when a smoother needs the stretch once more.
#pragma once

#include <cstddef>

#include "base/diagnostics.h"
#include "base/result.h"
#include "estimate/body_filter.h"
#include "estimate/foot_contacts.h"

namespace limbwave::estimate {

/// Instants are told by their number in the recording. One that comes again shall be treated as the first time: what
/// was decided then is remembered, so that a stretch filtered twice is the same twice.
class BodyStepHook {
 public:
  BodyStepHook() = default;
  BodyStepHook(const BodyStepHook&) = delete;
  BodyStepHook& operator=(const BodyStepHook&) = delete;
  virtual ~BodyStepHook() = default;

  /// Starts the filter from the first readings of a recording; findings are those of the start.
  virtual Result<Diagnostics> start(BodyFilter& filter, const BodyReadings& readings) = 0;
  /// Before the step of an instant: what of its readings shall be used. May change the filter; where that forgets
  /// velocities and accelerations, `record->forgets` says so (always set when there is a record).
  virtual BodyInstant before(BodyFilter& filter, const BodyInstant& instant, std::size_t number,
                             StepRecord* record) = 0;
  /// Behind the step: updates by measurements of its own, appended to the record.
  virtual void after(BodyFilter& filter, const BodyInstant& instant, std::size_t number, StepRecord* record) = 0;
  /// Who holds the root by its feet, where somebody does; null: it is where the filter has it.
  [[nodiscard]] virtual const FootContacts* feet() const { return nullptr; }
  /// Behind the last step of the forward run.
  virtual void finished(const BodyFilter& /*filter*/) {}
};

}  // namespace limbwave::estimate
