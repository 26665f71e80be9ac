// SPDX-License-Identifier: MIT
/// @file
/// Four pairs in a register of 256 bits, with the vectors of AVX2; other processors go the long
/// way.
///
/// Intrinsics, where the rest of the protocol has none: in plain C++ this takes five times as many
/// instructions, and one instruction for each of a frame's bytes is more than it may cost.
#include "protocol/frame_lanes.hpp"

#include "protocol/accelerators/marcher.hpp"

#if defined(__x86_64__)

#include <immintrin.h>

#include <cstring>

// Each function is compiled for these instructions, whatever the rest is compiled for; it must then
// be inlined wherever it is called, so that no register has to go through memory.
#define RAYMARCH_AVX2 [[gnu::target("avx2,bmi,bmi2,popcnt")]]
#define RAYMARCH_INLINE_AVX2 [[gnu::target("avx2,bmi,bmi2,popcnt"), gnu::always_inline]] inline

namespace raymarch::protocol
{
namespace
{

/// Asked once. Before this is set, during the start of the program, frames go the long way.
const bool available = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
                       __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("popcnt");

using Vector = __m256i;

/// In front of the text, for the eight or sixteen bytes that are read before a comma; behind it,
/// for the eight that are read from a key on.
constexpr std::size_t padding = 16;
/// How many bounds are stored at once, wanted or not.
constexpr std::size_t bounds_at_once = 4;

/// A copy of the text that may be read beyond its ends, and where its pairs lie.
struct PaddedText
{
    alignas(32) std::array<char, padding + max_lanes_text + padding> bytes;
    /// Indices into `bytes`: one before the text, each comma, the text's end. One word of commas
    /// more than are wanted may be stored before that is noticed.
    std::array<std::uint32_t, max_lanes + 64 + bounds_at_once> bounds;
};

RAYMARCH_INLINE_AVX2 Vector all(std::uint64_t value)
{
    return _mm256_set1_epi64x(static_cast<long long>(value));
}

template <typename T>
RAYMARCH_INLINE_AVX2 Vector at(const T* lanes)
{
    return _mm256_load_si256(reinterpret_cast<const Vector*>(lanes));
}

template <typename T = std::uint64_t>
RAYMARCH_INLINE_AVX2 T load8(const char* bytes)
{
    static_assert(sizeof(T) == 8);
    T value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// Copies 32 bytes; bit i says whether byte i is a comma.
RAYMARCH_INLINE_AVX2 std::uint64_t copy_half(const char* from, char* to)
{
    const Vector bytes = _mm256_loadu_si256(reinterpret_cast<const Vector*>(from));
    _mm256_storeu_si256(reinterpret_cast<Vector*>(to), bytes);
    const Vector commas = _mm256_cmpeq_epi8(bytes, _mm256_set1_epi8(','));
    return static_cast<std::uint32_t>(_mm256_movemask_epi8(commas));
}
RAYMARCH_INLINE_AVX2 std::uint64_t copy_block(const char* from, char* to)
{
    const std::uint64_t low = copy_half(from, to);
    return copy_half(from + 32, to + 32) << 32 | low;
}

/// Stores `base` plus the place of each bit, some at once without asking how many there are: a
/// branch for each would be guessed wrong more often than the work that it saves is worth.
RAYMARCH_INLINE_AVX2 std::uint32_t* store_places(std::uint64_t bits, std::size_t base,
                                                 std::uint32_t* bounds)
{
    std::uint32_t* const end = bounds + _mm_popcnt_u64(bits);
    do {
        for (std::size_t i = 0; i < bounds_at_once; ++i) {
            *bounds++ = static_cast<std::uint32_t>(base + _tzcnt_u64(bits));
            bits = _blsr_u64(bits);
        }
    } while (bounds < end);
    return end;
}

/// Copies the text of at least 64 bytes and finds its pairs; whether there are `pairs` of them.
RAYMARCH_INLINE_AVX2 bool find_pairs(std::string_view text, std::size_t pairs, PaddedText& padded)
{
    char* const bytes = padded.bytes.data() + padding;
    std::memset(padded.bytes.data(), 0, padding);
    std::uint32_t* bounds = padded.bounds.data();
    std::uint32_t* const last = bounds + pairs;
    *bounds++ = padding - 1;
    std::size_t begin = 0;
    for (; begin + 64 <= text.size(); begin += 64) {
        bounds =
            store_places(copy_block(text.data() + begin, bytes + begin), padding + begin, bounds);
        if (bounds > last)
            return false;
    }
    if (begin < text.size()) { // the last 64 bytes, without those that have been looked at
        const std::size_t from = text.size() - 64;
        const std::uint64_t commas = copy_block(text.data() + from, bytes + from);
        bounds = store_places(commas >> (begin - from), padding + begin, bounds);
    }
    std::memset(bytes + text.size(), 0, padding);
    *bounds = static_cast<std::uint32_t>(padding + text.size());
    return bounds == last;
}

/// Eight bytes from so far behind each of four places.
RAYMARCH_INLINE_AVX2 Vector load_four(const char* bytes, const std::uint32_t* places,
                                      std::ptrdiff_t behind)
{
    const long long first = load8<long long>(bytes + (std::ptrdiff_t{places[0]} + behind));
    const long long second = load8<long long>(bytes + (std::ptrdiff_t{places[1]} + behind));
    const long long third = load8<long long>(bytes + (std::ptrdiff_t{places[2]} + behind));
    const long long fourth = load8<long long>(bytes + (std::ptrdiff_t{places[3]} + behind));
    return _mm256_set_epi64x(fourth, third, second, first);
}
RAYMARCH_INLINE_AVX2 Vector widen_four(const std::uint32_t* places)
{
    return _mm256_cvtepu32_epi64(_mm_loadu_si128(reinterpret_cast<const __m128i*>(places)));
}

/// What is wrong with four numbers: any bit of `form`, the sign of `range`.
struct Faults
{
    Vector form;
    Vector range;
};

/// Four numbers, `-12.345` or `-12.34`, to codes. `chars` are the eight bytes before the comma, of
/// which the value begins `spare` bits from the lowest; `i` is the first lane.
///
/// Rounding: with s thousandths and f fraction bits, the code is the integer nearest to
/// c = s * 2^f / 1000. The factor is F = 2^(32 + f) / 1000 + e with 0 <= e < 1, so s * F is 2^32 *
/// c
/// + s * e. With f >= 3, c is a multiple of 1/125, so it is not half-way between two integers, and
/// at least 1/250 from there: 2^32 / 250 in s * F, while s * e < 4294967 = 2^32 / 1000. So s * F +
/// 2^31, cut off below 2^32, is the nearest integer.
template <const FrameLanes& lanes>
RAYMARCH_INLINE_AVX2 Vector quantize_four(std::size_t i, Vector chars, Vector spare, Faults& faults)
{
    // Digits become 0 to 9, '.' 0x1E, '-' 0x1D. The value to the lowest byte: is the first one '-'?
    Vector value = _mm256_srlv_epi64(_mm256_xor_si256(chars, all(0x3030'3030'3030'3030)), spare);
    const Vector minus = _mm256_cmpeq_epi64(_mm256_and_si256(value, all(0xFF)), all(0x1D));
    value = _mm256_xor_si256(value, _mm256_and_si256(minus, all(0x1D))); // a leading zero now
    value = _mm256_sllv_epi64(value, spare); // back, with zeros in place of what is not the value's

    // The point is to be in byte 4. In byte 5, where only a point has bit 4, there are two
    // decimals: a byte down, which makes the third a zero, and must not lose a digit.
    const Vector shift = _mm256_and_si256(_mm256_srli_epi64(value, 41), all(8));
    const Vector lost = _mm256_and_si256(value, all(0xFF));
    const Vector digits = _mm256_xor_si256(_mm256_srlv_epi64(value, shift), all(0x1E'0000'0000));
    const Vector no_digit = _mm256_subs_epu8(digits, all(0x0909'0900'0909'0909));
    faults.form = _mm256_or_si256(faults.form, _mm256_or_si256(lost, no_digit));

    // Thousandths, by pairs: tens, hundreds, then 1000 times what stands before the point.
    const Vector pairs = _mm256_maddubs_epi16(digits, _mm256_set1_epi16(0x010A));
    const Vector fours = _mm256_madd_epi16(pairs, _mm256_set1_epi32(0x0001'0064));
    const Vector thousandths =
        _mm256_add_epi64(_mm256_mul_epu32(fours, all(1000)), _mm256_srli_epi64(fours, 32));
    const Vector most = _mm256_blendv_epi8(at(&lanes.most[i]), at(&lanes.most_negative[i]), minus);
    faults.range = _mm256_or_si256(faults.range, _mm256_sub_epi64(most, thousandths));

    const Vector high = _mm256_mul_epu32(thousandths, at(&lanes.factor_high[i]));
    const Vector product = _mm256_add_epi64(_mm256_mul_epu32(thousandths, at(&lanes.factor[i])),
                                            _mm256_slli_epi64(high, 32));
    const Vector nearest = _mm256_srli_epi64(_mm256_add_epi64(product, all(1U << 31)), 32);
    const Vector code = _mm256_sub_epi64(_mm256_xor_si256(nearest, minus), minus);
    // Held at the largest code. As halves: the upper half of a code is 0 or -1, and so stays.
    return _mm256_min_epi32(code, at(&lanes.largest_code[i]));
}

enum class Outcome : std::uint8_t { Read, OtherKeys, OtherNumbers };

/// The pairs of the number lanes; that of lane i lies between the places `before[i]` and `end[i]`.
template <const FrameLanes& lanes>
RAYMARCH_INLINE_AVX2 Outcome read_numbers(const char* bytes, const std::uint32_t* before,
                                          const std::uint32_t* end, std::int64_t* codes)
{
    Faults faults{_mm256_setzero_si256(), _mm256_setzero_si256()};
    for (std::size_t i = 0; i < lanes.numbers; i += lanes_per_block) {
        const Vector keys =
            _mm256_and_si256(load_four(bytes, before + i, 1), at(&lanes.key_mask[i]));
        const Vector other = _mm256_xor_si256(keys, at(&lanes.key_bits[i]));
        if (_mm256_testz_si256(other, other) == 0)
            return Outcome::OtherKeys;
        // A value of no byte, or of more than eight, is shifted out: it has no point then.
        const Vector length = _mm256_sub_epi64(widen_four(end + i), widen_four(before + i));
        const Vector spare =
            _mm256_sub_epi64(at(&lanes.value_begin[i]), _mm256_slli_epi64(length, 3));
        const Vector chars = load_four(bytes, end + i, -8);
        _mm256_storeu_si256(reinterpret_cast<Vector*>(codes + i),
                            quantize_four<lanes>(i, chars, spare, faults));
    }
    const bool good = _mm256_testz_si256(faults.form, faults.form) != 0 &&
                      _mm256_testz_si256(faults.range, all(std::uint64_t{1} << 63)) != 0;
    return good ? Outcome::Read : Outcome::OtherNumbers;
}

/// The pairs of the choice lanes: a name as the table writes it.
template <const FrameLanes& lanes>
RAYMARCH_INLINE_AVX2 bool read_choices(const char* bytes, const std::uint32_t* before,
                                       const std::uint32_t* end, std::int64_t* codes)
{
    std::size_t read = lanes.numbers;
    for (std::size_t i = 0; i < lanes.choice_count; ++i) {
        const LaneChoice& choice = lanes.choices[i];
        const std::size_t lane = choice.lane;
        const std::size_t value_begin = before[lane] + (lanes.value_begin[lane] - 64) / 8;
        if (end[lane] - value_begin != choice.length)
            continue;
        const std::uint64_t key = load8(bytes + before[lane] + 1);
        const std::uint64_t other =
            ((key & lanes.key_mask[lane]) ^ lanes.key_bits[lane]) |
            ((load8(bytes + end[lane] - 16) & choice.masks[0]) ^ choice.bits[0]) |
            ((load8(bytes + end[lane] - 8) & choice.masks[1]) ^ choice.bits[1]);
        if (other != 0)
            continue;
        codes[lane] = choice.code;
        ++read;
    }
    return read == lanes.size;
}

/// Where the pairs of a frame in any order lie, by lanes; false when that is not one pair each.
template <const FrameLanes& lanes>
RAYMARCH_INLINE_AVX2 bool sort_pairs(const PaddedText& padded, std::uint32_t* before,
                                     std::uint32_t* end)
{
    std::uint32_t given = 0;
    for (std::size_t i = 0; i < lanes.size; ++i) {
        const std::uint64_t front = load8(padded.bytes.data() + padded.bounds[i] + 1);
        const std::size_t lane = lanes.lane_of_hash[lane_hash(front, lanes.hash_factor)];
        given |= std::uint32_t{1} << lane;
        before[lane] = padded.bounds[i];
        end[lane] = padded.bounds[i + 1];
    }
    return given == (std::uint32_t{1} << lanes.size) - 1;
}

template <const FrameLanes& lanes>
RAYMARCH_AVX2 bool read_with_avx2(std::string_view text, std::int64_t* codes) noexcept
{
    PaddedText padded; // NOLINT(*-member-init): what is read has been written before
    if (!find_pairs(text, lanes.size, padded))
        return false;
    const char* const bytes = padded.bytes.data();
    const std::uint32_t* before = padded.bounds.data();
    const std::uint32_t* end = before + 1;
    Outcome outcome = read_numbers<lanes>(bytes, before, end, codes);
    std::array<std::uint32_t, max_lanes> before_lane; // NOLINT(*-member-init)
    std::array<std::uint32_t, max_lanes> end_lane;    // NOLINT(*-member-init)
    if (outcome == Outcome::OtherKeys) {
        if (!sort_pairs<lanes>(padded, before_lane.data(), end_lane.data()))
            return false;
        before = before_lane.data();
        end = end_lane.data();
        outcome = read_numbers<lanes>(bytes, before, end, codes);
    }
    return outcome == Outcome::Read && read_choices<lanes>(bytes, before, end, codes);
}

} // namespace

bool has_frame_lanes() noexcept
{
    return available;
}

template <const FrameLanes& lanes>
bool read_frame_by_lanes(std::string_view text, State& state) noexcept
{
    if (text.size() < 64 || text.size() > max_lanes_text || !available)
        return false;
    return read_with_avx2<lanes>(text, state.codes.data());
}

} // namespace raymarch::protocol

#else

namespace raymarch::protocol
{

bool has_frame_lanes() noexcept
{
    return false;
}

template <const FrameLanes& lanes>
bool read_frame_by_lanes(std::string_view /*text*/, State& /*state*/) noexcept
{
    return false;
}

} // namespace raymarch::protocol

#endif

namespace raymarch::protocol
{

// One line an accelerator with lanes.
template bool read_frame_by_lanes<marcher::frame_lanes>(std::string_view, State&) noexcept;

} // namespace raymarch::protocol
