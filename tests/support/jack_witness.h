/// Asks a JACK server how it keeps time: a client that counts lost periods.
#pragma once

#include <jack/jack.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

namespace limbwave::test {

class JackWitness {
 public:
  /// Waits until the server answers, for at most so long.
  explicit JackWitness(std::chrono::seconds patience) {
    const auto limit = std::chrono::steady_clock::now() + patience;
    while (client_ == nullptr && std::chrono::steady_clock::now() < limit) {
      client_ = jack_client_open("witness", JackNoStartServer, nullptr);
      if (client_ == nullptr) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
    }
    if (client_ != nullptr) {
      jack_set_xrun_callback(
          client_,
          [](void* self) {
            ++static_cast<JackWitness*>(self)->lost_;
            return 0;
          },
          this);
      jack_activate(client_);
    }
  }
  ~JackWitness() {
    if (client_ != nullptr) {
      jack_client_close(client_);
    }
  }
  JackWitness(const JackWitness&) = delete;
  JackWitness& operator=(const JackWitness&) = delete;

  [[nodiscard]] bool answers() const { return client_ != nullptr; }
  /// Periods that the server has lost since this began.
  [[nodiscard]] int lost_periods() const { return lost_; }
  [[nodiscard]] jack_client_t* client() const { return client_; }

 private:
  jack_client_t* client_ = nullptr;
  std::atomic<int> lost_{0};
};

}  // namespace limbwave::test
