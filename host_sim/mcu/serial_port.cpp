#include "mcu/serial_port.hpp"

namespace spanline::host {

void SerialPort::begin(std::uint64_t at) {
  byte_ = waiting_.front();
  waiting_.pop_front();
  shifting_ = true;
  hears_ = false;
  now_ = {at, at + (in_no_time_ ? 0 : cycles_per_byte_), false};
}

void SerialPort::begin_listening(std::uint64_t at) {
  shifting_ = hears_ = true;
  now_ = {at, at + cycles_per_byte_, false};
}

void SerialPort::listen(bool on, std::uint64_t now) {
  listening_ = on;
  if (on && !shifting_) begin_listening(now);
}

void SerialPort::end_byte() {
  shifting_ = false;
  const std::uint8_t answer = hears_ ? wire_.listen(hz_, now_) : wire_.exchange(byte_, hz_, mode_, now_);
  if (received_.size() < depth_) received_.push_back(answer);
  if (listening_) {
    begin_listening(now_.end);
  } else if (!waiting_.empty()) {
    begin(now_.end);
  }
}

std::uint8_t SerialPort::take_received() {
  if (received_.empty()) return last_received_;
  last_received_ = received_.front();
  received_.pop_front();
  return last_received_;
}

}  // namespace spanline::host
