#include "acquire/driver_box_card.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <thread>
#include <utility>

#include "acquire/card_plan.h"
#include "acquire/card_sync.h"
#include "acquire/duplex_stream.h"

namespace limbwave::acquire {
namespace {

constexpr double kReopen = 1.0;         // seconds from one try to the next
constexpr std::int64_t kSearch = 2048;  // samples about the place where a mark is expected
constexpr int kAgree = 2;               // rounds that must agree that it has moved
constexpr int kMostSlots = 64;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class CardBox : public BoxSource {
 public:
  CardBox(std::string id, CardBoxSettings settings) : id_(std::move(id)), settings_(std::move(settings)) {
    schedule_.resize(static_cast<std::size_t>(std::max(1, settings_.sources)));
    std::iota(schedule_.begin(), schedule_.end(), std::uint8_t{0});
  }
  ~CardBox() override { stop(); }
  CardBox(const CardBox&) = delete;
  CardBox& operator=(const CardBox&) = delete;

  // With a mark where the card has room for it.
  Status open() {
    auto stream = DuplexStream::open(id_, plan(true), settings_.client);
    marked_ = stream.ok();
    if (!stream) {
      auto without = DuplexStream::open(id_, plan(false), settings_.client);
      if (!without) {
        return without.error();
      }
      stream = std::move(without);
    }
    stream_ = *std::move(stream);
    return {};
  }

  [[nodiscard]] BoxHello hello() const override {
    BoxHello hello;
    hello.rate_hz = static_cast<float>(settings_.rate_hz);
    hello.wires = settings_.wires;
    hello.sources = settings_.sources;
    hello.slot_samples = settings_.slot_samples;
    hello.pulse_hz = static_cast<float>(settings_.pulse_hz);
    hello.serial = std::hash<std::string>{}(id_);
    hello.firmware = "sound card";
    hello.schedule = schedule_;
    return hello;
  }
  [[nodiscard]] StreamFormat format() const override {
    return {SampleRate{settings_.rate_hz}, settings_.wires, SampleType::kFloat32};
  }
  [[nodiscard]] std::string title() const override { return "sound card " + id_; }
  [[nodiscard]] BoxCounters counters() const override { return counters_; }
  [[nodiscard]] BoxStatus status() const override { return {}; }
  [[nodiscard]] bool connected() const override { return connected_; }

  Status set_schedule(const std::vector<std::uint8_t>& schedule) override {
    const bool possible = !schedule.empty() && schedule.size() <= kMostSlots &&
                          std::all_of(schedule.begin(), schedule.end(), [&](std::uint8_t source) {
                            return source == kSilentSlot || source < settings_.sources;
                          });
    if (running_ || !possible) {
      return Error{"refuses the order in which sources are to fire", id_, "check that the rig belongs to this card"};
    }
    if (schedule == schedule_ && stream_ != nullptr) {
      return {};
    }
    schedule_ = schedule;
    stream_.reset();
    return open();
  }

  Status start() override {
    if (running_) {
      return {};
    }
    if (stream_ == nullptr) {
      if (Status opened = open(); !opened) {
        return opened;
      }
    }
    if (Status started = stream_->start(); !started) {
      return started;
    }
    running_ = connected_ = true;
    begin_search();
    last_sample_s_ = now_s();
    return {};
  }

  void stop() override {
    running_ = false;
    DuplexStream::retire(std::move(stream_));
  }

  BoxPart pull(double timeout_s) override;

 private:
  [[nodiscard]] int inputs() const { return settings_.wires + (marked_ ? 1 : 0); }
  [[nodiscard]] std::int64_t round() const {
    return std::int64_t{settings_.slot_samples} * static_cast<std::int64_t>(schedule_.size());
  }
  [[nodiscard]] DuplexPlan plan(bool marked) const { return card_plan(settings_, schedule_, marked); }
  void begin_search() {
    found_ = false;
    search_since_s_ = now_s();
    heard_.clear();
    forgotten_ = looked_ = 0;
    moved_ = 0;
    agreed_ = 0;
  }
  void lose(BoxPart& part, std::int64_t frames, const std::string& why);
  void take(BoxPart& part, std::span<const float> frames);
  void search(BoxPart& part);
  void watch(BoxPart& part);
  void reopen(BoxPart& part);

  std::string id_;
  CardBoxSettings settings_;
  std::vector<std::uint8_t> schedule_;
  std::unique_ptr<DuplexStream> stream_;
  bool marked_ = false, running_ = false, connected_ = false, found_ = false, begun_ = false;
  BoxCounters counters_;
  std::int64_t position_ = 0;  // of the next sample
  std::int64_t read_ = 0;      // frames read from the stream
  std::vector<float> fresh_;
  std::vector<float> heard_;    // while searching: the newest frames; then unused
  std::int64_t forgotten_ = 0;  // frames before those
  std::int64_t looked_ = 0;     // how many were there at the last look
  std::vector<float> marks_;    // of the mark's input, ending at `position_`
  std::int64_t next_mark_ = 0;  // sample at which the next one is expected
  std::int64_t moved_ = 0;      // where the last one was instead
  int agreed_ = 0;
  double search_since_s_ = 0.0, last_sample_s_ = 0.0, lost_at_s_ = 0.0, next_try_s_ = 0.0;
  std::optional<DuplexStream::Loss> loss_;
};

void CardBox::lose(BoxPart& part, std::int64_t frames, const std::string& why) {
  if (frames <= 0) {
    return;
  }
  part.events.push_back(
      {SampleIndex{position_}, "dropped", fmt::format("{} samples were lost: {}", frames, why), frames});
  part.pieces.push_back({frames, {}});
  position_ += frames;
  counters_.lost_frames += static_cast<std::uint64_t>(frames);
  ++counters_.gaps;
  if (marked_) {
    // Silence keeps the place of what is watched.
    marks_.insert(marks_.end(), static_cast<std::size_t>(std::min<std::int64_t>(frames, 4 * round())), 0.0F);
  }
}

// Frames of all inputs, in their place.
void CardBox::take(BoxPart& part, std::span<const float> frames) {
  if (frames.empty()) {
    return;
  }
  const auto all = static_cast<std::size_t>(inputs());
  const auto wires = static_cast<std::size_t>(settings_.wires);
  const std::size_t count = frames.size() / all;
  if (part.pieces.empty()) {
    part.pieces.emplace_back();
  }
  auto& bytes = part.pieces.back().bytes;
  for (std::size_t n = 0; n < count; ++n) {
    const auto wire_bytes = std::as_bytes(frames.subspan(n * all, wires));
    bytes.insert(bytes.end(), wire_bytes.begin(), wire_bytes.end());
    if (marked_) {
      marks_.push_back(frames[n * all + wires]);
    }
  }
  position_ += static_cast<std::int64_t>(count);
  ++counters_.blocks;
  last_sample_s_ = now_s();
}

// Finds where the first round is heard; what came before is no part of the take.
void CardBox::search(BoxPart& part) {
  const auto all = static_cast<std::size_t>(inputs());
  const std::int64_t frames = static_cast<std::int64_t>(heard_.size() / all);
  if (frames < looked_ + round()) {
    return;
  }
  looked_ = frames;
  std::optional<std::int64_t> at;
  bool by_mark = false;
  if (marked_ && frames >= 2 * round() + kMarkSamples) {
    std::vector<float> mark(static_cast<std::size_t>(frames));
    for (std::size_t n = 0; n < mark.size(); ++n) {
      mark[n] = heard_[n * all + static_cast<std::size_t>(settings_.wires)];
    }
    at = find_mark(mark);
    by_mark = at.has_value();
  }
  if (!at && (!marked_ || now_s() - search_since_s_ > settings_.patience_s)) {
    // The first round that is still here.
    const std::int64_t delay = std::llround(stream_->reported_delay());
    const std::int64_t rounds = std::max<std::int64_t>(0, (forgotten_ - delay + round() - 1) / round());
    at = delay + rounds * round() - forgotten_;
    if (*at >= frames) {
      at.reset();
    }
  }
  if (!at) {
    const std::int64_t old = frames - 4 * round();
    if (old > 0) {
      heard_.erase(heard_.begin(), heard_.begin() + old * static_cast<std::ptrdiff_t>(all));
      forgotten_ += old;
      looked_ -= old;
    }
    return;
  }
  found_ = true;
  if (begun_) {
    // It was away: how long is known by our own clock alone. Slots keep their places.
    const double waited = static_cast<double>(frames - *at) / settings_.rate_hz;
    const auto passed = static_cast<std::int64_t>((now_s() - last_sample_s_ - waited) * settings_.rate_hz);
    const std::int64_t place = (position_ + std::max<std::int64_t>(0, passed) + round() - 1) / round() * round();
    lose(part, place - position_, "the sound card was away; by the computer's clock");
    ++counters_.reconnects;
    connected_ = true;
    part.events.push_back({SampleIndex{position_}, "line-back",
                           fmt::format("the sound card is back after {:.1f} s", now_s() - lost_at_s_), 0});
  }
  if (!by_mark) {
    part.events.push_back({SampleIndex{position_}, "no-mark",
                           "no mark is heard from the outputs; delays are as the sound card says, and may be off", 0});
  }
  begun_ = true;
  marks_.clear();
  next_mark_ = position_ + (by_mark ? 0 : INT64_MAX / 2);
  take(part, std::span<const float>(heard_).subspan(static_cast<std::size_t>(*at) * all));
  heard_ = {};
}

// The marks stay where they are, or outputs and inputs came apart.
void CardBox::watch(BoxPart& part) {
  while (marked_ && position_ >= next_mark_ + kSearch + kMarkSamples) {
    const std::int64_t start = position_ - static_cast<std::int64_t>(marks_.size());  // of marks_[0]
    const std::int64_t first = std::max(start, next_mark_ - kSearch);
    const std::int64_t last = next_mark_ + kSearch + kMarkSamples;
    std::optional<std::int64_t> at;
    if (last > first) {
      at = find_mark(std::span<const float>(marks_).subspan(static_cast<std::size_t>(first - start),
                                                            static_cast<std::size_t>(last - first)));
    }
    if (at) {
      const std::int64_t moved = first + *at - next_mark_;
      agreed_ = moved != 0 && moved == moved_ ? agreed_ + 1 : (moved != 0 ? 1 : 0);
      moved_ = moved;
      if (moved != 0 && agreed_ >= kAgree) {
        if (moved < 0) {
          lose(part, -moved, "the sound card left them out");
        } else {
          // Outputs are late: they leave out as much, and until then ranges are not.
          stream_->skip_output(moved);
          part.events.push_back({SampleIndex{position_}, "resynchronised",
                                 fmt::format("outputs were late by {} samples and are put right", moved), moved});
        }
        moved_ = agreed_ = 0;
        next_mark_ += round();  // what is on its way is still as it was
      }
    }
    next_mark_ += round();
  }
  const auto keep = static_cast<std::size_t>(2 * kSearch + 2 * kMarkSamples + 2 * round());
  if (marks_.size() > 4 * keep) {
    marks_.erase(marks_.begin(), marks_.end() - static_cast<std::ptrdiff_t>(keep));
  }
}

void CardBox::reopen(BoxPart& part) {
  if (connected_) {
    connected_ = false;
    lost_at_s_ = now_s();
    next_try_s_ = lost_at_s_ + kReopen;
    part.events.push_back(
        {SampleIndex{position_}, "line-lost", "the sound card does not answer any more; waiting for it", 0});
    DuplexStream::retire(std::move(stream_));
  }
  if (now_s() < next_try_s_) {
    return;
  }
  next_try_s_ = now_s() + kReopen;
  if (open() && stream_->start()) {
    read_ = 0;
    loss_.reset();
    begin_search();
  } else {
    stream_.reset();
  }
}

BoxPart CardBox::pull(double timeout_s) {
  BoxPart part;
  if (!running_) {
    return part;
  }
  if (stream_ == nullptr || !stream_->alive()) {
    reopen(part);
    if (stream_ == nullptr) {
      std::this_thread::sleep_for(std::chrono::duration<double>(std::min(timeout_s, 0.1)));
      return part;
    }
  }
  stream_->wait(timeout_s);
  const std::size_t frames = stream_->read(fresh_);
  const auto all = static_cast<std::size_t>(inputs());
  const std::uint64_t overflows = stream_->overflows();
  counters_.stalls = overflows;
  if (!found_) {
    heard_.insert(heard_.end(), fresh_.begin(), fresh_.end());
    read_ += static_cast<std::int64_t>(frames);
    DuplexStream::Loss ignored;
    if (stream_->next_loss(ignored)) {
      begin_search();  // with a hole in it nothing is certain
    }
    search(part);
    watch(part);
    return part;
  }
  // Losses stand where they happened.
  std::size_t done = 0;
  while (true) {
    if (!loss_) {
      DuplexStream::Loss next;
      if (stream_->next_loss(next)) {
        loss_ = next;
      }
    }
    if (!loss_ || loss_->at > read_ + static_cast<std::int64_t>(frames)) {
      break;
    }
    const auto until = static_cast<std::size_t>(std::max<std::int64_t>(0, loss_->at - read_));
    take(part, std::span<const float>(fresh_).subspan(done * all, (until - done) * all));
    done = until;
    lose(part, loss_->frames, "the computer was too slow for the sound card");
    loss_.reset();
  }
  take(part, std::span<const float>(fresh_).subspan(done * all));
  read_ += static_cast<std::int64_t>(frames);
  watch(part);
  return part;
}

}  // namespace

Result<std::unique_ptr<BoxSource>> open_card_box(const std::string& id, const CardBoxSettings& settings) {
  auto box = std::make_unique<CardBox>(id, settings);
  if (Status opened = box->open(); !opened) {
    return opened.error();
  }
  return std::unique_ptr<BoxSource>(std::move(box));
}

}  // namespace limbwave::acquire
