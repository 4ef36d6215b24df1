// A sound card as a driver box for real: a JACK server, and a room between our outputs and our inputs.
#include "acquire/driver_box_card.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <jack/jack.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "support/jack_server.h"
#include "support/jack_witness.h"

namespace limbwave::acquire {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;

constexpr int kWires = 18;
constexpr int kSources = 8;
constexpr int kPeriod = 8192;
constexpr auto kPatience = seconds(40);

// How many samples sound needs from a source to a wire's microphone.
constexpr int delay(int source, int wire) {
  return 40 + 13 * source + 29 * wire;
}

// Another client of the server: every microphone hears every source later, the last input hears the last output.
class Room {
 public:
  explicit Room(bool with_mark) : with_mark_(with_mark) {
    client_ = jack_client_open("room", JackNoStartServer, nullptr);
    if (client_ == nullptr) {
      return;
    }
    for (int i = 0; i <= kSources; ++i) {
      in_.push_back(jack_port_register(client_, ("in_" + std::to_string(i)).c_str(), JACK_DEFAULT_AUDIO_TYPE,
                                       JackPortIsInput, 0));
    }
    for (int i = 0; i <= kWires; ++i) {
      out_.push_back(jack_port_register(client_, ("out_" + std::to_string(i)).c_str(), JACK_DEFAULT_AUDIO_TYPE,
                                        JackPortIsOutput, 0));
    }
    jack_set_process_callback(
        client_, [](jack_nframes_t n, void* self) { return static_cast<Room*>(self)->run(n); }, this);
    jack_activate(client_);
  }
  ~Room() {
    if (client_ != nullptr) {
      jack_client_close(client_);
    }
  }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;

  [[nodiscard]] bool open() const { return client_ != nullptr; }

  // Between the outputs and inputs of a client; false as long as it does not have them.
  bool connect(const std::string& name) const {
    bool all = true;
    for (int i = 0; i <= kSources; ++i) {
      const int done =
          jack_connect(client_, (name + ":out_" + std::to_string(i)).c_str(), ("room:in_" + std::to_string(i)).c_str());
      all = all && (done == 0 || done == EEXIST);
    }
    for (int i = 0; i <= kWires; ++i) {
      const std::string input = name + ":in_" + std::to_string(i);
      const int done = jack_connect(client_, ("room:out_" + std::to_string(i)).c_str(), input.c_str());
      all = all && (done == 0 || done == EEXIST);
      (void)jack_disconnect(client_, ("system:capture_" + std::to_string(i + 1)).c_str(), input.c_str());
    }
    return all;
  }

 private:
  int run(jack_nframes_t frames) {
    for (jack_nframes_t n = 0; n < frames; ++n, ++now_) {
      for (std::size_t s = 0; s < kSources; ++s) {
        past_[s][now_ % kPast] = static_cast<float*>(jack_port_get_buffer(in_[s], frames))[n];
      }
    }
    for (int w = 0; w < kWires; ++w) {
      float* out = static_cast<float*>(jack_port_get_buffer(out_[static_cast<std::size_t>(w)], frames));
      for (jack_nframes_t n = 0; n < frames; ++n) {
        float sum = 0.0F;
        for (int s = 0; s < kSources; ++s) {
          const std::size_t then = now_ - frames + n + kPast - static_cast<std::size_t>(delay(s, w));
          sum += 0.25F * past_[static_cast<std::size_t>(s)][then % kPast];
        }
        out[n] = sum;
      }
    }
    float* mark = static_cast<float*>(jack_port_get_buffer(out_[kWires], frames));
    const float* from = static_cast<float*>(jack_port_get_buffer(in_[kSources], frames));
    for (jack_nframes_t n = 0; n < frames; ++n) {
      mark[n] = with_mark_ ? -0.3F * from[n] : 0.0F;  // a cable with the wrong polarity, and weak
    }
    return 0;
  }

  static constexpr std::size_t kPast = 16384;
  bool with_mark_;
  jack_client_t* client_ = nullptr;
  std::vector<jack_port_t*> in_, out_;
  std::array<std::array<float, kPast>, kSources> past_{};
  std::size_t now_ = kPast;
};

struct Heard {
  std::vector<float> samples;  // all wires, gaps as zeros
  std::vector<BoxEvent> events;
  [[nodiscard]] std::int64_t frames() const { return static_cast<std::int64_t>(samples.size()) / kWires; }
};

void pull(BoxSource& box, Heard& heard) {
  const BoxPart part = box.pull(0.05);
  heard.events.insert(heard.events.end(), part.events.begin(), part.events.end());
  for (const BoxPiece& piece : part.pieces) {
    heard.samples.insert(heard.samples.end(), static_cast<std::size_t>(piece.lost) * kWires, 0.0F);
    const std::size_t old = heard.samples.size();
    heard.samples.resize(old + piece.bytes.size() / sizeof(float));
    std::memcpy(heard.samples.data() + old, piece.bytes.data(), piece.bytes.size());
  }
}

class DriverBoxCard : public testing::Test {
 protected:
  void SetUp() override {
    std::string why_not;
    if (!test::JackServer::available(why_not)) {
      GTEST_SKIP() << why_not;
    }
    server_ = std::make_unique<test::JackServer>(192000, 20, 20, kPeriod);
    witness_ = std::make_unique<test::JackWitness>(kPatience);
    ASSERT_TRUE(witness_->answers()) << server_->log();
    settings_.client = "box";
    settings_.patience_s = 12.0;
  }
  // Opens and starts the box in the room.
  void begin(const std::vector<std::uint8_t>& schedule, bool with_mark) {
    const auto limit = steady_clock::now() + kPatience;
    Result<std::unique_ptr<BoxSource>> opened = Error{"not tried yet", "", ""};
    while (!opened && steady_clock::now() < limit) {
      opened = open_card_box("portaudio:JACK:system", settings_);
      std::this_thread::sleep_for(milliseconds(100));
    }
    if (!opened && lost_periods() > 0) {
      GTEST_SKIP() << "the sound server has lost " << lost_periods() << " periods: " << opened.error().text();
    }
    ASSERT_TRUE(opened.ok()) << opened.error().text() << server_->log();
    box_ = *std::move(opened);
    room_ = std::make_unique<Room>(with_mark);
    ASSERT_TRUE(room_->open());
    ASSERT_TRUE(box_->set_schedule(schedule).ok());
    ASSERT_TRUE(box_->start().ok());
    while (!room_->connect("box") && steady_clock::now() < limit) {
      std::this_thread::sleep_for(milliseconds(20));
    }
  }
  // By the server's own account: a machine that is too busy to keep time loses some, and nothing else may.
  [[nodiscard]] int lost_periods() const { return witness_->lost_periods(); }
  // Slots that periods which the server lost may have spoilt: the room is a client of it and misses them too.
  [[nodiscard]] int touched() const { return lost_periods() * (kPeriod / settings_.slot_samples + 2) * kWires; }
  void listen(Heard& heard, std::int64_t frames) {
    const auto limit = steady_clock::now() + kPatience;
    while (heard.frames() < frames && steady_clock::now() < limit) {
      pull(*box_, heard);
    }
    if (heard.frames() < frames && lost_periods() > 0) {
      GTEST_SKIP() << "the sound server has lost " << lost_periods() << " periods";
    }
    ASSERT_GE(heard.frames(), frames);
  }

  std::unique_ptr<test::JackServer> server_;
  std::unique_ptr<test::JackWitness> witness_;
  CardBoxSettings settings_;
  std::unique_ptr<BoxSource> box_;
  std::unique_ptr<Room> room_;
};

// How many slots on all wires have their pulse at the very sample at which the room lets it arrive, how many do not;
// slots near an event are left out.
struct Slots {
  int right = 0, wrong = 0, silent = 0;
};
Slots look(const Heard& heard, const std::vector<std::uint8_t>& schedule, int slot_samples) {
  Slots slots;
  const std::int64_t round = static_cast<std::int64_t>(schedule.size()) * slot_samples;
  for (std::int64_t slot = 0; (slot + 1) * slot_samples <= heard.frames(); ++slot) {
    const std::int64_t first = slot * slot_samples;
    bool near = false;
    for (const BoxEvent& event : heard.events) {
      const std::int64_t end = event.sample.value + (event.kind == "dropped" ? event.count : 0);
      near = near || (event.sample.value - 4 * round < first + slot_samples && end + 4 * round > first);
    }
    const int source = schedule[static_cast<std::size_t>(slot) % schedule.size()];
    for (int w = 0; w < kWires && !near; ++w) {
      int arrival = -1;
      for (int n = 0; n < slot_samples && arrival < 0; ++n) {
        const auto at = static_cast<std::size_t>((first + n) * kWires + w);
        arrival = std::abs(heard.samples[at]) > 0.1F ? n : -1;
      }
      const int expected = source == kSilentSlot ? -1 : delay(source, w);
      slots.right += arrival == expected ? 1 : 0;
      slots.wrong += arrival != expected ? 1 : 0;
      slots.silent += arrival < 0 ? 1 : 0;
    }
  }
  return slots;
}

TEST_F(DriverBoxCard, SourcesAndMicrophonesStayTogetherToTheSample) {
  const std::vector<std::uint8_t> schedule{0, 1, 2, 3, 4, 5, 6, 7};
  ASSERT_NO_FATAL_FAILURE(begin(schedule, true));
  if (IsSkipped()) {
    return;
  }
  Heard heard;
  listen(heard, 3 * 192000);
  if (IsSkipped() || HasFatalFailure()) {
    return;
  }
  EXPECT_EQ(box_->format().type, SampleType::kFloat32);
  EXPECT_EQ(box_->format().channels, kWires);
  EXPECT_EQ(box_->hello().slot_samples, settings_.slot_samples);
  const bool marked = std::none_of(heard.events.begin(), heard.events.end(),
                                   [](const BoxEvent& event) { return event.kind == "no-mark"; });
  if (!marked && lost_periods() > 0) {
    GTEST_SKIP() << "the sound server has lost " << lost_periods() << " periods, and marks with them";
  }
  ASSERT_TRUE(marked) << "no mark is heard though the server has lost nothing";
  const Slots slots = look(heard, schedule, settings_.slot_samples);
  EXPECT_LE(slots.wrong, touched());
  std::printf("%d pulses right, %zu events, %d periods lost\n", slots.right, heard.events.size(), lost_periods());
  if (lost_periods() == 0) {
    EXPECT_TRUE(heard.events.empty()) << heard.events.front().kind << ": " << heard.events.front().text;
    EXPECT_GT(slots.right, 5000);
  }
  box_->stop();
}

TEST_F(DriverBoxCard, AScheduleWithSilenceIsPlayedAsItIs) {
  const std::vector<std::uint8_t> schedule{5, kSilentSlot, 2};
  ASSERT_NO_FATAL_FAILURE(begin(schedule, true));
  if (IsSkipped()) {
    return;
  }
  Heard heard;
  listen(heard, 192000);
  if (IsSkipped() || HasFatalFailure()) {
    return;
  }
  const Slots slots = look(heard, schedule, settings_.slot_samples);
  EXPECT_LE(slots.wrong, touched());
  if (lost_periods() == 0) {
    EXPECT_TRUE(heard.events.empty()) << heard.events.front().kind << ": " << heard.events.front().text;
    EXPECT_GT(slots.silent, 100);
    EXPECT_GT(slots.right, 500);
  }
  EXPECT_FALSE(box_->set_schedule({0}).ok()) << "it is running";
  box_->stop();
  EXPECT_FALSE(box_->set_schedule({9}).ok()) << "there are eight sources";
}

TEST_F(DriverBoxCard, WithoutAMarkItSaysSo) {
  settings_.patience_s = 0.5;
  const std::vector<std::uint8_t> schedule{0, 1, 2, 3, 4, 5, 6, 7};
  ASSERT_NO_FATAL_FAILURE(begin(schedule, false));
  if (IsSkipped()) {
    return;
  }
  Heard heard;
  listen(heard, 96000);
  if (IsSkipped() || HasFatalFailure()) {
    return;
  }
  EXPECT_TRUE(std::any_of(heard.events.begin(), heard.events.end(),
                          [](const BoxEvent& event) { return event.kind == "no-mark"; }));
}

TEST_F(DriverBoxCard, ACardThatIsTooSmallIsNamed) {
  settings_.wires = 40;
  const auto limit = steady_clock::now() + kPatience;
  std::string error;
  while (error.find("has 20 inputs") == std::string::npos && steady_clock::now() < limit) {
    const auto opened = open_card_box("portaudio:JACK:system", settings_);
    ASSERT_FALSE(opened.ok());
    error = opened.error().text();
    std::this_thread::sleep_for(milliseconds(100));
  }
  EXPECT_THAT(error, testing::HasSubstr("has 20 inputs and 20 outputs, but 40 and 8 are needed"));
}

}  // namespace
}  // namespace limbwave::acquire
