#include <simavr/avr_adc.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

#include <filesystem>
#include <stdexcept>

#include "tests/firmware/board.hpp"

namespace rva::test {
namespace {

constexpr std::uint32_t supply_mv = 5000;
// Registers of the ATmega2560 for pin 6 (PH3, OC4A), as addresses in its data space.
constexpr std::size_t port_h = 0x102;
constexpr std::size_t timer_4_control = 0xA0;
constexpr std::size_t timer_4_compare = 0xA8;
constexpr avr_cycle_count_t cycles_a_step = 1600;  // a tenth of a millisecond at 16 MHz

elf_firmware_t read() {
  elf_firmware_t firmware{};
  if (elf_read_firmware(RVA_FIRMWARE_ELF, &firmware) != 0)
    throw std::runtime_error("cannot read " RVA_FIRMWARE_ELF);
  return firmware;
}

/// The built program on simavr's ATmega2560.
class SimulatedBoard : public Firmware {
 public:
  SimulatedBoard() {
    elf_firmware_t firmware = read();
    avr_ = avr_make_mcu_by_name("atmega2560");
    avr_init(avr_);
    avr_->frequency = 16000000;
    avr_->vcc = avr_->avcc = avr_->aref = supply_mv;
    avr_->log = LOG_NONE;
    avr_->sleep = [](avr_t*, avr_cycle_count_t) {};
    avr_load_firmware(avr_, &firmware);
    connect('0', to_host);
    connect('1', to_servos);
  }
  ~SimulatedBoard() override { avr_terminate(avr_); }
  SimulatedBoard(const SimulatedBoard&) = delete;
  SimulatedBoard& operator=(const SimulatedBoard&) = delete;

  void from_host(std::uint8_t byte) override { raise('0', byte); }
  void from_servos(std::uint8_t byte) override { raise('1', byte); }
  void set_thermistor(double share) override {
    avr_raise_irq(avr_io_getirq(avr_, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0),
                  static_cast<std::uint32_t>(share * supply_mv));
  }
  [[nodiscard]] double lamp() override {
    const bool pulses = (avr_->data[timer_4_control] & 0x80) != 0;
    if (pulses) return avr_->data[timer_4_compare] / 255.0;
    return (avr_->data[port_h] & 0x08) != 0 ? 1.0 : 0.0;
  }
  void step() override {
    until_ += cycles_a_step;
    while (avr_->cycle < until_) {
      const int state = avr_run(avr_);
      if (state == cpu_Done || state == cpu_Crashed) throw std::runtime_error("the firmware crashed");
    }
  }

 private:
  void connect(char uart, std::vector<std::uint8_t>& to) {
    std::uint32_t flags = 0;
    avr_ioctl(avr_, static_cast<std::uint32_t>(AVR_IOCTL_UART_GET_FLAGS(uart)), &flags);
    flags &= ~static_cast<std::uint32_t>(AVR_UART_FLAG_STDIO | AVR_UART_FLAG_POLL_SLEEP);
    avr_ioctl(avr_, static_cast<std::uint32_t>(AVR_IOCTL_UART_SET_FLAGS(uart)), &flags);
    avr_irq_register_notify(
        avr_io_getirq(avr_, static_cast<std::uint32_t>(AVR_IOCTL_UART_GETIRQ(uart)), UART_IRQ_OUTPUT),
        [](avr_irq_t*, std::uint32_t value, void* written) {
          static_cast<std::vector<std::uint8_t>*>(written)->push_back(static_cast<std::uint8_t>(value));
        },
        &to);
  }
  void raise(char uart, std::uint8_t byte) {
    avr_raise_irq(
        avr_io_getirq(avr_, static_cast<std::uint32_t>(AVR_IOCTL_UART_GETIRQ(uart)), UART_IRQ_INPUT), byte);
  }

  avr_t* avr_ = nullptr;
  avr_cycle_count_t until_ = 0;
};

}  // namespace

std::unique_ptr<Firmware> simulated_board() {
  if (!std::filesystem::exists(RVA_FIRMWARE_ELF)) return nullptr;
  return std::make_unique<SimulatedBoard>();
}

std::optional<BuiltSize> built_size() {
  if (!std::filesystem::exists(RVA_FIRMWARE_ELF)) return std::nullopt;
  const elf_firmware_t firmware = read();
  return BuiltSize{firmware.flashsize, firmware.datasize + firmware.bsssize};
}

}  // namespace rva::test
