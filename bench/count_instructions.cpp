// SPDX-License-Identifier: MIT
/// @file
/// A plugin of qemu-user for programs of armhf: counts the instructions that they run, in a file
/// that can be read at any time, also while they run:
///
///     qemu-arm -plugin libcount_instructions.so,counter=FILE PROGRAM
///
/// FILE has eight bytes, a number in the machine's order. The count begins anew with each write of
/// the program to its standard output: so a program says where its start ends. Each instruction
/// adds one when it is run, so that a block left in its middle (by a signal, say) is not counted
/// whole; one whose condition does not hold counts too, as a processor retires it. What the kernel
/// does is not in it. For programs of one thread: the addition is not atomic.
///
/// Debian has no package with qemu-plugin.h: of version 1 of that interface, what is used here is
/// declared here, under its own names.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string_view>

extern "C" {
using qemu_plugin_id_t = std::uint64_t;
struct qemu_info_t;
struct qemu_plugin_tb; // a block of translated instructions
struct qemu_plugin_insn;
enum qemu_plugin_op { QEMU_PLUGIN_INLINE_ADD_U64 };

using Translated = void(qemu_plugin_id_t, qemu_plugin_tb*);
using SystemCall = void(qemu_plugin_id_t, unsigned cpu, std::int64_t number, std::uint64_t,
                        std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t,
                        std::uint64_t, std::uint64_t);
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, Translated* callback);
void qemu_plugin_register_vcpu_syscall_cb(qemu_plugin_id_t id, SystemCall* callback);
std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb* tb);
qemu_plugin_insn* qemu_plugin_tb_get_insn(const qemu_plugin_tb* tb, std::size_t index);
void qemu_plugin_register_vcpu_insn_exec_inline(qemu_plugin_insn* insn, qemu_plugin_op op,
                                                void* value, std::uint64_t operand);

// What it looks for in a plugin.
extern const int qemu_plugin_version;
int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* info, int argc, char** argv);
}

namespace
{

std::uint64_t* instructions = nullptr;

void count(qemu_plugin_id_t /*id*/, qemu_plugin_tb* block)
{
    const std::size_t length = qemu_plugin_tb_n_insns(block);
    for (std::size_t i = 0; i < length; ++i)
        qemu_plugin_register_vcpu_insn_exec_inline(qemu_plugin_tb_get_insn(block, i),
                                                   QEMU_PLUGIN_INLINE_ADD_U64, instructions, 1);
}

void begin_anew(qemu_plugin_id_t /*id*/, unsigned /*cpu*/, std::int64_t number, std::uint64_t fd,
                std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t,
                std::uint64_t, std::uint64_t)
{
    constexpr std::int64_t write_on_arm = 4;
    if (number == write_on_arm && fd == STDOUT_FILENO)
        *instructions = 0;
}

/// The number in a file that is at least as long; null when it cannot be mapped.
std::uint64_t* map_number(const char* path)
{
    const int file = ::open(path, O_RDWR | O_CLOEXEC);
    void* const page =
        ::mmap(nullptr, sizeof *instructions, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    return page == MAP_FAILED ? nullptr : static_cast<std::uint64_t*>(page);
}

} // namespace

const int qemu_plugin_version = 1;

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* /*info*/, int argc, char** argv)
{
    constexpr std::string_view option = "counter=";
    if (argc == 1 && std::string_view(argv[0]).starts_with(option))
        instructions = map_number(argv[0] + option.size());
    if (instructions == nullptr) {
        static_cast<void>(
            std::fputs("count_instructions: counter=FILE names a file of eight bytes\n", stderr));
        return 1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, count);
    qemu_plugin_register_vcpu_syscall_cb(id, begin_anew);
    return 0;
}
