// limbwave-driver-box-emulator: a driver box on a pseudo-terminal, for tests and for work without hardware.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <deque>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>

#include "acquire/box_ports.h"
#include "body/rig.h"
#include "emulator.h"
#include "simulate/driver_box_stream.h"
#include "take/take_reader.h"

namespace {

using limbwave::Error;
using limbwave::Result;

std::atomic<bool> interrupted{false};

void interrupt(int /*signal*/) {
  interrupted = true;
}

struct Options {
  std::string motion = "walk", rig = "driver-box-body", errors = "paper", take, faults;
  std::uint64_t seed = 1;
  int threads = 2;
  limbwave::emulator::EmulatorSettings settings;
};

// Slots made ahead on a thread of its own, so that a slow moment of the simulation delays nothing.
class Maker {
 public:
  using Make = std::function<std::vector<std::int16_t>(bool from_start)>;
  explicit Maker(Make make) : make_(std::move(make)), thread_([this] { run(); }) {}
  ~Maker() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  Maker(const Maker&) = delete;
  Maker& operator=(const Maker&) = delete;

  /// What is made from now on differs from what has been made ahead.
  void forget() {
    const std::lock_guard lock(mutex_);
    used_ = true;
  }

  void get(std::vector<std::int16_t>& out, std::size_t count, bool from_start) {
    std::unique_lock lock(mutex_);
    if (from_start && used_) {
      ready_.clear();
      rest_.clear();
      ++epoch_;
      again_ = true;
      changed_.notify_all();
    }
    used_ = true;
    while (rest_.size() < count) {
      changed_.wait(lock, [&] { return !ready_.empty(); });
      rest_.insert(rest_.end(), ready_.front().begin(), ready_.front().end());
      ready_.pop_front();
      changed_.notify_all();
    }
    out.assign(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(count));
    rest_.erase(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(count));
  }

 private:
  static constexpr std::size_t kAhead = 64;  // slots
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return stopping_ || again_ || ready_.size() < kAhead; });
      if (stopping_) {
        return;
      }
      const bool from_start = std::exchange(again_, false);
      const int epoch = epoch_;
      lock.unlock();
      std::vector<std::int16_t> slot = make_(from_start);
      lock.lock();
      if (epoch == epoch_) {
        ready_.push_back(std::move(slot));
        changed_.notify_all();
      }
    }
  }
  Make make_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::vector<std::int16_t>> ready_;
  std::vector<std::int16_t> rest_;
  int epoch_ = 0;
  bool again_ = true, stopping_ = false, used_ = false;
  std::thread thread_;  // last: it uses the others
};

// Sources by slot, as the maker's thread finds them when it begins anew.
struct Scheduled {
  std::mutex mutex;
  std::vector<std::uint8_t> schedule;
};

struct Supply {
  Maker::Make make;
  limbwave::emulator::Schedule schedule;
};

Result<Supply> simulated(const Options& options, limbwave::acquire::BoxHello& hello) {
  const auto rig = limbwave::body::load_rig(options.rig);
  if (!rig) {
    return rig.error();
  }
  if (!rig->driver_box) {
    return Error{"has no driver box", "rig \"" + rig->name + "\"", "use driver-box-body"};
  }
  const auto skeleton = limbwave::body::load_skeleton(rig->skeleton);
  const auto errors = limbwave::simulate::load_driver_box_errors(options.errors);
  if (!skeleton || !errors) {
    return skeleton ? errors.error() : skeleton.error();
  }
  const auto actor =
      limbwave::simulate::DriverBoxActor::create(options.motion, 0.0, *rig, *skeleton, *errors, options.seed);
  if (!actor) {
    return actor.error();
  }
  hello.rate_hz = static_cast<float>(rig->driver_box->rate_hz);
  hello.wires = static_cast<int>(rig->microphones.size());
  hello.bits = rig->driver_box->bits;
  hello.sources = static_cast<int>(rig->sources.size());
  hello.slot_samples = rig->driver_box->slot_samples;
  hello.pulse_hz = static_cast<float>(rig->driver_box->pulse_hz);
  auto stream = std::make_shared<std::unique_ptr<limbwave::simulate::DriverBoxStream>>();
  auto scheduled = std::make_shared<Scheduled>();
  Supply supply;
  supply.schedule = [scheduled](const std::vector<std::uint8_t>& schedule) {
    const std::lock_guard lock(scheduled->mutex);
    scheduled->schedule = schedule;
    return true;
  };
  supply.make = [=, rig = *rig, actor = *actor, errors = *errors, seed = options.seed,
                 threads = options.threads](bool from_start) {
    if (from_start || !*stream) {
      *stream = std::make_unique<limbwave::simulate::DriverBoxStream>(rig, actor, errors, 22.0, seed);
      (*stream)->set_threads(threads);
      const std::lock_guard lock(scheduled->mutex);
      if (!scheduled->schedule.empty()) {
        (*stream)->set_schedule(scheduled->schedule);
      }
    }
    std::vector<std::int16_t> slot(static_cast<std::size_t>((*stream)->slot_samples() * (*stream)->wires()));
    (*stream)->next_slot(slot);
    (void)(*stream)->take_pulses();
    for (int w = 0; w < (*stream)->wires(); ++w) {
      (void)(*stream)->take_frames(w);
    }
    return slot;
  };
  return supply;
}

// A recorded take, again and again.
Result<Supply> recorded(const Options& options, limbwave::acquire::BoxHello& hello) {
  const auto take = limbwave::take::open_take(options.take);
  if (!take) {
    return take.error();
  }
  if (!take->info.rig.driver_box || take->info.format.type != limbwave::acquire::SampleType::kInt16) {
    return Error{"is no take of a driver box", options.take, "use one that was recorded with --driver-box"};
  }
  auto opened = limbwave::take::TakeReader::open(*take);
  if (!opened) {
    return opened.error();
  }
  const auto& box = *take->info.rig.driver_box;
  hello.rate_hz = static_cast<float>(take->info.format.rate.hz);
  hello.wires = take->info.format.channels;
  hello.bits = box.bits;
  hello.sources = static_cast<int>(take->info.rig.sources.size());
  hello.slot_samples = box.slot_samples;
  hello.pulse_hz = static_cast<float>(box.pulse_hz);
  auto reader = std::make_shared<limbwave::take::TakeReader>(std::move(opened).value());
  auto at = std::make_shared<std::int64_t>(0);
  // Whole rounds only, so that sources keep their slots when it begins anew.
  const std::int64_t round = std::int64_t{box.slot_samples} * std::max(1, hello.sources);
  const std::int64_t frames = reader->frames() / round * round;
  if (frames == 0) {
    return Error{"is shorter than one round of the sources", options.take, "use a longer one"};
  }
  Supply supply;
  // It fires as it was recorded.
  supply.schedule = [sources = hello.sources](const std::vector<std::uint8_t>& schedule) {
    for (std::size_t slot = 0; slot < schedule.size(); ++slot) {
      if (schedule[slot] != slot) {
        return false;
      }
    }
    return static_cast<int>(schedule.size()) == sources;
  };
  supply.make = [=](bool from_start) {
    *at = from_start || *at >= frames ? 0 : *at;
    std::vector<std::int16_t> slot(static_cast<std::size_t>(box.slot_samples * hello.wires));
    (void)reader->read_raw(limbwave::SampleIndex{*at}, std::as_writable_bytes(std::span(slot)));
    *at += box.slot_samples;
    return slot;
  };
  return supply;
}

int run(const Options& options) {
  const auto fail = [](const Error& error) {
    std::fputs(("limbwave-driver-box-emulator: " + error.text() + "\n").c_str(), stderr);
    return 1;
  };
  limbwave::acquire::BoxHello hello;
  hello.serial = 1000 + options.seed;
  hello.session = 1;
  hello.firmware = "emulator " LIMBWAVE_VERSION;
  const auto supply = options.take.empty() ? simulated(options, hello) : recorded(options, hello);
  if (!supply) {
    return fail(supply.error());
  }
  Maker maker(supply->make);
  const auto wires = static_cast<std::size_t>(hello.wires);
  limbwave::emulator::EmulatorSettings settings = options.settings;
  if (settings.link.empty()) {
    std::error_code code;
    std::filesystem::create_directories(limbwave::acquire::emulator_folder(), code);
    settings.link = (limbwave::acquire::emulator_folder() / std::to_string(::getpid())).string();
  }
  const std::string link = settings.link;
  if (!options.faults.empty()) {
    auto faults = limbwave::emulator::load_faults(options.faults);
    if (!faults) {
      return fail(faults.error());
    }
    settings.faults = *std::move(faults);
  }
  limbwave::emulator::Emulator emulator(
      hello, std::move(settings),
      [&](std::vector<std::int16_t>& out, int frames, bool from_start) {
        maker.get(out, static_cast<std::size_t>(frames) * wires, from_start);
      },
      [&](const std::vector<std::uint8_t>& schedule) {
        maker.forget();
        return supply->schedule(schedule);
      });
  if (const auto opened = emulator.open(); !opened) {
    return fail(opened.error());
  }
  fmt::print("{}\n", link);
  std::fflush(stdout);
  if (const auto ran = emulator.run([] { return interrupted.load(); }, STDIN_FILENO); !ran) {
    return fail(ran.error());
  }
  return 0;
}

int start(int argc, char** argv) {
  Options options;
  CLI::App app("A driver box in software: speaks its protocol on a pseudo-terminal, in real time.");
  app.set_version_flag("--version", LIMBWAVE_VERSION);
  app.add_option("--motion", options.motion, "Motion that is simulated, or a .bvh file")->capture_default_str();
  app.add_option("--rig", options.rig, "Rig: a name or a file")->capture_default_str();
  app.add_option("--errors", options.errors, "Error profile: none, calibrated, paper or a file")->capture_default_str();
  app.add_option("--take", options.take, "A recorded take instead of a simulation");
  app.add_option("--seed", options.seed, "Seed of everything random")->capture_default_str();
  app.add_option(
      "--link", options.settings.link,
      "Symbolic link that always leads to the terminal; else one that `limbwave devices` and the studio find");
  app.add_option("--log", options.settings.log, "File that tells every fault, one JSON object a line");
  app.add_option("--seconds", options.settings.seconds, "End after this time; 0: at Ctrl-C")
      ->check(CLI::Range(0.0, 864000.0));
  app.add_option("--speed", options.settings.speed,
                 "Times real time: below 1 for slow computers; samples stay the same")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  app.add_option("--block", options.settings.block_frames, "Frames of a block")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  app.add_option("--faults-every", options.settings.faults_every_s, "Mean seconds between faults of its own; 0: none")
      ->check(CLI::Range(0.0, 86400.0));
  app.add_option("--faults", options.faults, "File of faults: lines SECONDS FAULT, counted from the first start");
  app.add_option("--threads", options.threads, "Threads of the simulation")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.footer("Faults on request, as lines on standard input or in the file of --faults:\n" +
             limbwave::emulator::fault_help() +
             "Example: limbwave-driver-box-emulator --motion walk --link /tmp/box --faults-every 5\n"
             "         limbwave record walk.take --driver-box /tmp/box --seconds 60");
  CLI11_PARSE(app, argc, argv);
  options.settings.seed = options.seed;
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  std::signal(SIGPIPE, SIG_IGN);
  return run(options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return start(argc, argv);
  } catch (const std::exception& exception) {
    std::fprintf(stderr, "limbwave-driver-box-emulator: unexpected failure: %s\n", exception.what());
    return 1;
  } catch (...) {
    return 1;
  }
}
