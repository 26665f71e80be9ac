// SPDX-License-Identifier: MIT
#include "cli/typed_bytes.hpp"
#include "cli/typed_lines.hpp"

#include <fmt/format.h>
#include <histedit.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace raymarch::cli
{
namespace
{

constexpr int history_length = 1000;
/// The bytes of one paste or of one key come closer together than this.
constexpr int pause_ms = 20;

struct Binding
{
    const char* key;
    const char* command;
};
constexpr const char* complete_command = "raymarch-complete";
constexpr std::array bindings = {
    Binding{"^I", complete_command},          Binding{"^R", "em-inc-search-prev"},
    Binding{"\\e[1~", "ed-move-to-beg"}, // Home
    Binding{"\\e[7~", "ed-move-to-beg"},      Binding{"\\e[H", "ed-move-to-beg"},
    Binding{"\\e[4~", "ed-move-to-end"}, // End
    Binding{"\\e[8~", "ed-move-to-end"},      Binding{"\\e[F", "ed-move-to-end"},
    Binding{"\\e[3~", "ed-delete-next-char"}, // Delete
    Binding{"\\e[1;5C", "em-next-word"},      // Ctrl and an arrow
    Binding{"\\e[1;5D", "ed-prev-word"},
};

struct EndEditor
{
    void operator()(EditLine* editor) const noexcept { ::el_end(editor); }
};
struct EndHistory
{
    void operator()(History* history) const noexcept { ::history_end(history); }
};

class EditedLines final : public TypedLines
{
  public:
    using Complete = std::function<Completion(std::string_view)>;

    EditedLines(int stop_fd, std::string prompt, std::string history_file, Complete complete)
        : stop_fd_(stop_fd)
        , prompt_(std::move(prompt))
        , history_file_(std::move(history_file))
        , complete_(std::move(complete))
    {}

    ~EditedLines() override
    {
        if (history_ == nullptr || history_file_.empty())
            return;
        std::error_code ignored;
        std::filesystem::create_directories(std::filesystem::path(history_file_).parent_path(),
                                            ignored);
        HistEvent event = {};
        ::history(history_.get(), &event, H_SAVE, history_file_.c_str());
    }

    /// Returns false if the terminal cannot be set up.
    bool open()
    {
        history_.reset(::history_init());
        editor_.reset(::el_init("raymarchctl", stdin, stdout, stderr));
        if (history_ == nullptr || editor_ == nullptr)
            return false;
        HistEvent event = {};
        ::history(history_.get(), &event, H_SETSIZE, history_length);
        if (!history_file_.empty())
            ::history(history_.get(), &event, H_LOAD, history_file_.c_str());
        EditLine* const editor = editor_.get();
        ::el_set(editor, EL_CLIENTDATA, this);
        ::el_set(editor, EL_PROMPT, &EditedLines::prompt);
        ::el_set(editor, EL_GETCFN, &EditedLines::get_character);
        ::el_set(editor, EL_HIST, ::history, history_.get());
        ::el_set(editor, EL_SIGNAL, 1); // for the window size and Ctrl-Z
        ::el_set(editor, EL_EDITOR, "emacs");
        ::el_set(editor, EL_ADDFN, complete_command, "completes a word", &EditedLines::on_tab);
        for (const Binding& binding : bindings)
            ::el_set(editor, EL_BIND, binding.key, binding.command, nullptr);
        // The terminal stays in this mode between two lines. In line mode it would drop a Ctrl-D
        // and the end of a long paste that come before the reply.
        ::el_set(editor, EL_SETTY, "-x", "-icanon", "-echo", nullptr);
        ::el_source(editor, nullptr); // reads the user's ~/.editrc
        return true;
    }

    Result<std::optional<std::string>> next() override
    {
        static_cast<void>(std::fflush(stdout));
        stopped_ = false;
        int size = 0;
        const char* const typed = ::el_gets(editor_.get(), &size);
        if (stopped_ || typed == nullptr || size <= 0)
            return std::nullopt;
        std::string_view line(typed, static_cast<std::size_t>(size));
        if (line.ends_with('\n') || line.ends_with('\r'))
            line.remove_suffix(1);
        if (line.find_first_not_of(" \t") != std::string_view::npos) {
            HistEvent event = {};
            ::history(history_.get(), &event, H_ENTER, std::string(line).c_str());
        }
        return typed_bytes(line);
    }

  private:
    static EditedLines& of(EditLine* editor)
    {
        void* self = nullptr;
        ::el_get(editor, EL_CLIENTDATA, &self);
        return *static_cast<EditedLines*>(self);
    }

    static char* prompt(EditLine* editor) { return of(editor).prompt_.data(); }

    static int get_character(EditLine* editor, wchar_t* character)
    {
        return of(editor).read_character(*character);
    }

    static unsigned char on_tab(EditLine* editor, int /*key*/) { return of(editor).complete(); }

    /// Returns whether a byte can be read now or within the pause.
    [[nodiscard]] static bool byte_comes()
    {
        pollfd waiting = {.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
        return ::poll(&waiting, 1, pause_ms) > 0;
    }

    /// Appends a byte to `pending_`. Returns false at the end and if the program must stop.
    bool read_byte()
    {
        for (;;) {
            std::array<pollfd, 2> waiting = {
                pollfd{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0},
                pollfd{.fd = stop_fd_, .events = POLLIN, .revents = 0},
            };
            if (::poll(waiting.data(), waiting.size(), -1) < 0)
                continue; // a signal that libedit handles
            stopped_ = waiting[1].revents != 0;
            if (stopped_)
                return false;
            char byte = 0;
            const ssize_t size = ::read(STDIN_FILENO, &byte, 1);
            if (size < 0 && (errno == EINTR || errno == EAGAIN))
                continue;
            if (size <= 0)
                return false;
            pending_ += byte;
            return true;
        }
    }

    /// libedit expects 1 with a character and 0 at the end.
    int read_character(wchar_t& character)
    {
        for (;;) {
            if (pending_.empty() && !read_byte())
                return 0;
            TypedCharacter typed = typed_character(pending_, false);
            if (typed.size == 0) {
                if (byte_comes() && read_byte())
                    continue;
                if (stopped_)
                    return 0;
                typed = typed_character(pending_, true);
            }
            pending_.erase(0, typed.size);
            character = static_cast<wchar_t>(typed.code);
            return 1;
        }
    }

    unsigned char complete()
    {
        EditLine* const editor = editor_.get();
        if (!pending_.empty() || byte_comes()) { // the TAB was pasted
            ::el_insertstr(editor, "\t");
            return CC_REFRESH;
        }
        const LineInfo* const line = ::el_line(editor);
        const std::string_view before(line->buffer,
                                      static_cast<std::size_t>(line->cursor - line->buffer));
        const Completion found = complete_(before);
        if (found.words.empty())
            return CC_REFRESH_BEEP;
        if (found.text.size() == found.typed) { // there is nothing to add
            show(found.words);
            return CC_REDISPLAY;
        }
        ::el_deletestr(editor, static_cast<int>(found.typed));
        ::el_insertstr(editor, found.text.c_str());
        return CC_REFRESH;
    }

    static void show(const std::vector<std::string>& words)
    {
        constexpr std::size_t width = 78;
        std::string text = "\n";
        std::size_t column = 0;
        for (const std::string& word : words) {
            if (column > 0 && column + word.size() + 2 > width) {
                text += '\n';
                column = 0;
            }
            text += word + "  ";
            column += word.size() + 2;
        }
        fmt::print("{}\n", text);
        static_cast<void>(std::fflush(stdout));
    }

    int stop_fd_;
    std::string prompt_;
    std::string history_file_;
    Complete complete_;
    std::string pending_; ///< the first bytes of an incomplete character
    bool stopped_ = false;
    std::unique_ptr<History, EndHistory> history_;
    std::unique_ptr<EditLine, EndEditor> editor_; // declared last: it uses the history
};

} // namespace

std::unique_ptr<TypedLines>
edited_lines(int stop_fd, std::string prompt, std::string history,
             std::function<Completion(std::string_view before)> complete)
{
    // The editor uses UTF-8, whatever the user's locale is (typed_bytes.hpp).
    if (std::setlocale(LC_CTYPE, "C.UTF-8") == nullptr) // NOLINT(concurrency-mt-unsafe): one thread
        return nullptr;
    auto lines = std::make_unique<EditedLines>(stop_fd, std::move(prompt), std::move(history),
                                               std::move(complete));
    return lines->open() ? std::move(lines) : nullptr;
}

} // namespace raymarch::cli
