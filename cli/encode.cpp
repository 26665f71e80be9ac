// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl encode`: converts parameter frames to register words, without a service.
#include "cli/subcommands.hpp"
#include "cli/words.hpp"
#include "protocol/assignments.hpp"
#include "protocol/line_reader.hpp"
#include "protocol/registers.hpp"
#include "protocol/reply.hpp"
#include "protocol/request.hpp"

#include <fmt/format.h>
#include <sysexits.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>
#include <optional>

namespace raymarch::cli
{
namespace
{

using namespace protocol; // NOLINT(google-build-using-namespace): a file of few functions

/// Turns lines into replies and remembers whether one of them was an ERR.
class Encoder
{
  public:
    explicit Encoder(const Accelerator& accelerator)
        : accelerator_(accelerator)
        , initial_(initial_state(accelerator))
        , state_(initial_)
    {}

    /// Returns the reply to one line; it is empty for a line that has none.
    std::string_view reply_to(const Line& line)
    {
        const Request request = read_request(line, false);
        if (!request.answered())
            return {};
        reply_.begin(request.checksummed);
        if (const auto fault = encode(request)) {
            write_fault(reply_, accelerator_, *fault);
            refused_ = true;
        }
        std::string_view text = reply_.text(); // it ends in CR LF
        text.remove_suffix(2);
        return text;
    }

    [[nodiscard]] bool refused() const noexcept { return refused_; }
    [[nodiscard]] const State& state() const noexcept { return state_; }

  private:
    std::optional<Fault> encode(const Request& request)
    {
        if (request.kind == Request::Kind::Faulty)
            return request.fault;
        if (request.kind == Request::Kind::Command)
            return Fault{.code = ErrorCode::UnknownCommand,
                         .column = request.command_column,
                         .allowed = "encode takes parameter frames; commands are for the service"};
        state_ = initial_; // table rows that are not in the frame have their defaults
        if (auto fault = read_frame(accelerator_, request.text, state_))
            return fault;
        reply_ << "OK";
        write_words(reply_, accelerator_, pack(accelerator_, state_));
        reply_.end_line();
        return std::nullopt;
    }

    const Accelerator& accelerator_;
    State initial_;
    State state_;
    ReplyWriter reply_;
    bool refused_ = false;
};

/// Writes standard output in large pieces.
class Output
{
  public:
    ~Output() { flush(); }
    Output() = default;
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    void line(std::string_view text)
    {
        buffer_.append(text).push_back('\n');
        if (buffer_.size() >= piece)
            flush();
    }
    void flush()
    {
        std::string_view rest = buffer_;
        while (!rest.empty()) {
            const ssize_t size = ::write(STDOUT_FILENO, rest.data(), rest.size());
            if (size < 0 && errno == EINTR)
                continue;
            if (size < 0) {
                failed_ = true;
                break;
            }
            rest.remove_prefix(static_cast<std::size_t>(size));
        }
        buffer_.clear();
    }
    [[nodiscard]] bool failed() const noexcept { return failed_; }

  private:
    static constexpr std::size_t piece = 65'536;
    std::string buffer_;
    bool failed_ = false;
};

int encode_standard_input(const Accelerator& accelerator)
{
    Encoder encoder(accelerator);
    Output output;
    LineReader reader;
    const auto answer = [&](const Line& line) {
        if (const std::string_view reply = encoder.reply_to(line); !reply.empty())
            output.line(reply);
    };
    std::array<char, 65'536> chunk; // NOLINT(*-member-init): read before use
    while (!output.failed()) {
        const ssize_t size = ::read(STDIN_FILENO, chunk.data(), chunk.size());
        if (size < 0 && errno == EINTR)
            continue;
        if (size < 0)
            return report(errno_error(ErrorKind::InputOutput, "read", "standard input"));
        if (size == 0)
            break;
        std::string_view bytes(chunk.data(), static_cast<std::size_t>(size));
        while (const auto line = reader.next(bytes))
            answer(*line);
        output.flush(); // an interactive program waits for the reply
    }
    if (const auto line = reader.finish())
        answer(*line);
    output.flush();
    if (output.failed())
        return EX_IOERR;
    return encoder.refused() ? status_err_reply : EX_OK;
}

int encode_one(const Accelerator& accelerator, const std::string& text)
{
    Encoder encoder(accelerator);
    Output output;
    LineReader reader;
    std::string_view bytes = text;
    auto line = reader.next(bytes);
    if (!line)
        line = reader.finish();
    if (!line || !bytes.empty())
        return report(plain_error(ErrorKind::Usage, "LINE must be one line; write several "
                                                    "lines to standard input"));
    const std::string_view reply = encoder.reply_to(*line);
    if (reply.empty())
        return report(plain_error(ErrorKind::Usage, "the line is blank"));
    output.line(reply);
    if (!encoder.refused() && !basis_is_orthonormal(accelerator, encoder.state()))
        fmt::print(stderr, "raymarchctl: warning: {}\n",
                   "forward, right and up are not of length 1 and at right angles within 0.01");
    return encoder.refused() ? status_err_reply : EX_OK;
}

struct EncodeOptions
{
    std::string accelerator;
    std::optional<std::string> line;
};

} // namespace

void add_encode(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("encode", "prints the register words of a parameter frame");
    const auto options = std::make_shared<EncodeOptions>();
    command->add_option("LINE", options->line,
                        "parameter frame; without it, lines are read from standard input, and each "
                        "line that is not blank gets one reply");
    add_accelerator_option(*command, options->accelerator,
                           "name of the accelerator that the frame is for");
    command->callback([options, &run] {
        run = [options] {
            const auto accelerator = accelerator_named(options->accelerator);
            if (!accelerator)
                return report(accelerator.error());
            return options->line ? encode_one(**accelerator, *options->line)
                                 : encode_standard_input(**accelerator);
        };
    });
}

} // namespace raymarch::cli
