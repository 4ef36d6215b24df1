#include "common/marker_model.h"

#include <QUndoCommand>
#include <algorithm>
#include <cmath>
#include <utility>

#include "take/markers.h"

namespace limbwave::ui {
namespace {

take::TakeEvent event_of(const Marker& marker) {
  return {SampleIndex{marker.sample}, take::kMarker, marker.text.toStdString(), marker.number};
}

/// The line of events.jsonl that leads to `to`.
take::TakeEvent line_for(const std::optional<Marker>& from, const std::optional<Marker>& to) {
  return to ? event_of(*to) : take::TakeEvent{SampleIndex{from->sample}, take::kMarkerRemoved, "", from->number};
}

}  // namespace

/// One marker set, moved, renamed or deleted.
class MarkerCommand : public QUndoCommand {
 public:
  /// `done`: it has happened already, so that pushing it changes nothing.
  MarkerCommand(MarkerModel& model, MarkerChange change, const QString& text, int gesture, bool done)
      : QUndoCommand(text), model_(model), change_(std::move(change)), gesture_(gesture), done_(done) {}

  void redo() override {
    if (!std::exchange(done_, false)) {
      if (!model_.apply(change_.before, change_.after)) {
        setObsolete(true);
      } else if (model_.recording_) {
        model_.done_live_.emplace_back(change_, text());
      }
    }
  }
  void undo() override {
    if (!model_.apply(change_.after, change_.before)) {
      setObsolete(true);
    } else if (model_.recording_ && !model_.done_live_.empty()) {
      model_.done_live_.pop_back();
    }
  }
  [[nodiscard]] int id() const override { return gesture_ < 0 ? -1 : 0x6d6b; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const MarkerCommand*>(other);
    if (next == nullptr || next->gesture_ != gesture_ || next->change_.before != change_.after) {
      return false;
    }
    change_.after = next->change_.after;
    if (model_.recording_ && model_.done_live_.size() >= 2) {
      model_.done_live_.pop_back();
      model_.done_live_.back().first = change_;
    }
    return true;
  }

 private:
  MarkerModel& model_;
  MarkerChange change_;
  int gesture_;
  bool done_;
};

MarkerModel::MarkerModel(TakeDocument& document, LiveModel& live, SaveQueue& saves, QUndoStack& undo, QObject* parent)
    : QObject(parent), document_(document), live_(live), saves_(saves), undo_(undo) {
  connect(&document_, &TakeDocument::changed, this, &MarkerModel::follow_document);
  connect(&document_, &TakeDocument::events_changed, this, &MarkerModel::follow_document);
  connect(&live_, &LiveModel::recording_changed, this, &MarkerModel::follow_recording);
  follow_document();
}

void MarkerModel::follow_recording() {
  const bool now = live_.recording() && !live_.aside();
  if (now == recording_) {
    return;
  }
  recording_ = now;
  if (recording_) {
    folder_ = live_.recording_folder();
    done_live_.clear();
    markers_.clear();
    Q_EMIT changed();
  }
  // At its end the markers stay as they are shown until the take opens.
}

void MarkerModel::restore_undo() {
  const auto done = std::exchange(done_live_, {});
  if (document_.is_open() && document_.take()->folder == folder_) {
    for (const auto& [change, text] : done) {
      undo_.push(new MarkerCommand(*this, change, text, -1, true));
    }
  }
}

void MarkerModel::follow_document() {
  if (recording_) {
    return;
  }
  markers_.clear();
  if (const auto& take = document_.take()) {
    for (const take::TakeEvent& event : take->events) {
      if (take::is_marker(event)) {
        markers_.push_back({event.count, event.sample.value, QString::fromStdString(event.text)});
      }
    }
    std::stable_sort(markers_.begin(), markers_.end(),
                     [](const Marker& a, const Marker& b) { return a.sample < b.sample; });
  }
  Q_EMIT changed();
}

const Marker* MarkerModel::find(std::int64_t number) const {
  const auto found = std::find_if(markers_.begin(), markers_.end(),
                                  [number](const Marker& marker) { return marker.number == number; });
  return found == markers_.end() ? nullptr : &*found;
}

double MarkerModel::rate_hz() const {
  if (recording_) {
    return live_.snapshot() ? live_.snapshot()->format.rate.hz : 0.0;
  }
  return document_.is_open() ? document_.take()->info.format.rate.hz : 0.0;
}

double MarkerModel::time_s(const Marker& marker) const {
  const double rate = rate_hz();
  return rate > 0.0 ? static_cast<double>(marker.sample) / rate : 0.0;
}

double MarkerModel::duration_s() const {
  if (recording_) {
    return live_.snapshot() ? live_.snapshot()->recorded_s : 0.0;
  }
  return document_.is_open() && rate_hz() > 0.0 ? static_cast<double>(document_.take()->info.frames) / rate_hz() : 0.0;
}

bool MarkerModel::editable() const {
  return recording_ ? live_.recording() : document_.is_open();
}

QString MarkerModel::next_words() const {
  const auto taken = [this](const QString& text) {
    return std::any_of(markers_.begin(), markers_.end(), [&](const Marker& marker) { return marker.text == text; });
  };
  auto number = static_cast<int>(markers_.size()) + 1;
  while (taken(tr("Marker %1").arg(number))) {
    ++number;
  }
  return tr("Marker %1").arg(number);
}

bool MarkerModel::mark_now(const QString& text) {
  if (!recording_) {
    return false;
  }
  // The session alone knows which sample "now" is, and writes it.
  const std::optional<take::TakeEvent> event = live_.mark(text.isEmpty() ? next_words() : text);
  if (!event) {
    return false;
  }
  const Marker marker{event->count, event->sample.value, QString::fromStdString(event->text)};
  markers_.push_back(marker);
  newest_ = marker.number;
  done_live_.push_back({{std::nullopt, marker}, tr("set marker")});
  undo_.push(new MarkerCommand(*this, {std::nullopt, marker}, tr("set marker"), -1, true));
  Q_EMIT changed();
  return true;
}

bool MarkerModel::add(double time_s, const QString& text) {
  if (!editable() || !std::isfinite(time_s)) {
    return false;
  }
  std::int64_t number = 1;
  for (const Marker& marker : markers_) {
    number = std::max(number, marker.number + 1);
  }
  const double at = std::clamp(time_s, 0.0, duration_s());
  newest_ = number;
  return push({std::nullopt, Marker{number, std::llround(at * rate_hz()), text.isEmpty() ? next_words() : text}},
              tr("set marker"));
}

bool MarkerModel::rename(std::int64_t number, const QString& text) {
  const Marker* marker = find(number);
  const QString words = text.simplified();
  if (marker == nullptr || words.isEmpty() || words == marker->text) {
    return false;
  }
  return push({*marker, Marker{number, marker->sample, words}}, tr("rename marker"));
}

bool MarkerModel::move(std::int64_t number, double time_s, int gesture) {
  const Marker* marker = find(number);
  if (marker == nullptr || !std::isfinite(time_s)) {
    return false;
  }
  const std::int64_t sample = std::llround(std::clamp(time_s, 0.0, duration_s()) * rate_hz());
  return sample != marker->sample && push({*marker, Marker{number, sample, marker->text}}, tr("move marker"), gesture);
}

bool MarkerModel::remove(std::int64_t number) {
  const Marker* marker = find(number);
  return marker != nullptr && push({*marker, std::nullopt}, tr("delete marker"));
}

bool MarkerModel::push(MarkerChange change, const QString& text, int gesture) {
  if (!editable()) {
    return false;
  }
  undo_.push(new MarkerCommand(*this, std::move(change), text, gesture, false));
  return true;
}

bool MarkerModel::apply(const std::optional<Marker>& from, const std::optional<Marker>& to) {
  const std::int64_t number = from ? from->number : to->number;
  const Marker* present = find(number);
  const bool as_expected = from ? present != nullptr && *present == *from : present == nullptr;
  if (!editable() || !as_expected) {
    return false;
  }
  const take::TakeEvent line = line_for(from, to);
  if (recording_) {
    if (!live_.write_event(line)) {
      return false;
    }
    std::erase_if(markers_, [number](const Marker& marker) { return marker.number == number; });
    if (to) {
      const auto place = std::upper_bound(markers_.begin(), markers_.end(), *to,
                                          [](const Marker& a, const Marker& b) { return a.sample < b.sample; });
      markers_.insert(place, *to);
    }
    Q_EMIT changed();
    return true;
  }
  saves_.add(tr("The marker is not saved"), document_.take()->folder,
             [line](const std::filesystem::path& folder) { return take::append_event(folder, line); });
  std::vector<take::TakeEvent> events = document_.take()->events;
  events.push_back(line);
  document_.set_events(take::events_in_force(events));
  return true;
}

}  // namespace limbwave::ui
