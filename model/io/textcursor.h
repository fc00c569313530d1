// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/io/failure.h"
#include "model/io/textnumber.h"

#include <charconv>
#include <cstring>
#include <string_view>

namespace model::io {

/// Walks over the text of a mesh file and counts its lines. "Blank" is a space, tab or carriage return, so that lines
/// may end in \n or \r\n; a line never ends in \r alone.
class TextCursor
{
public:
    explicit TextCursor(std::string_view text)
        : mBegin(text.data())
        , mPosition(text.data())
        , mEnd(text.data() + text.size())
    {
        constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";
        if (text.starts_with(ByteOrderMark))
            mPosition += ByteOrderMark.size();
    }

    bool atEnd() const { return mPosition == mEnd; }
    /// At the end of the text or of a line.
    bool atLineEnd() const { return atEnd() || *mPosition == '\n'; }
    /// Where a token may end: at a blank or a line's end.
    bool atTokenEnd() const { return atLineEnd() || isBlank(*mPosition); }
    /// The character here, '\0' at the end.
    char peek() const { return atEnd() ? '\0' : *mPosition; }
    /// The character after this one, '\0' behind the end.
    char peekNext() const { return mEnd - mPosition > 1 ? mPosition[1] : '\0'; }
    void advance() { ++mPosition; }
    /// 1-based.
    std::uint64_t line() const { return mLine; }
    std::size_t offset() const { return std::size_t(mPosition - mBegin); }
    std::size_t left() const { return std::size_t(mEnd - mPosition); }
    std::string_view rest() const { return {mPosition, left()}; }

    bool atLineEndAfterBlanks()
    {
        skipBlanks();
        return atLineEnd();
    }
    void skipBlanks()
    {
        while (!atEnd() && isBlank(*mPosition))
            ++mPosition;
    }
    /// Also over `\` at the end of a line, which joins the next line to it.
    void skipBlanksAndContinuations()
    {
        skipBlanks();
        while (peek() == '\\' && skipContinuation())
            skipBlanks();
    }
    void skipLine()
    {
        const void *const end = std::memchr(mPosition, '\n', left());
        mPosition = end ? static_cast<const char *>(end) + 1 : mEnd;
        mLine += end != nullptr;
    }
    /// Over blanks, line ends and comments from `#` to the end of the line.
    void skipSpaceAndComments()
    {
        for (;;) {
            skipBlanks();
            if (atEnd() || (*mPosition != '\n' && *mPosition != '#'))
                return;
            skipLine();
        }
    }

    /// The characters up to the next blank or line end; empty at one.
    std::string_view token()
    {
        const char *const begin = mPosition;
        while (!atTokenEnd())
            ++mPosition;
        return {begin, std::size_t(mPosition - begin)};
    }

    /// False (and unmoved) unless a number starts here and a token ends after it.
    bool number(float &value)
    {
        const char *const after = parseFloat(mPosition, mEnd, value);
        if (!after || !endsToken(after))
            return false;
        mPosition = after;
        return true;
    }
    /// The same numbers, to the nearest double.
    bool number(double &value)
    {
        const char *const first = peek() == '+' ? mPosition + 1 : mPosition;
        float narrow = 0;
        if (!number(narrow))
            return false;
        if (std::from_chars(first, mPosition, value).ec != std::errc())
            value = double(narrow); // too large or too small for a double, too
        return true;
    }
    /// An integer with an optional sign; what follows it is the caller's to check. False (and unmoved) unless it fits.
    bool integer(std::int64_t &value)
    {
        const char *const first = peek() == '+' ? mPosition + 1 : mPosition;
        const auto [after, error] = std::from_chars(first, mEnd, value);
        if (error != std::errc())
            return false;
        mPosition = after;
        return true;
    }

    /// SyntaxError at this line: `expected` (a phrase for translators: QT_TRANSLATE_NOOP), but here is something else.
    tl::unexpected<Error> failExpected(const char *expected) const;

private:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
    bool endsToken(const char *p) const { return p == mEnd || *p == '\n' || *p == '\\' || isBlank(*p); }
    bool skipContinuation();

    const char *mBegin;
    const char *mPosition;
    const char *mEnd;
    std::uint64_t mLine = 1;
};

} // namespace model::io
