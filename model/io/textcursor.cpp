// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/textcursor.h"

namespace model::io {

bool TextCursor::skipContinuation()
{
    const char *p = mPosition + 1;
    if (p != mEnd && *p == '\r')
        ++p;
    if (p != mEnd && *p != '\n')
        return false;
    mLine += p != mEnd;
    mPosition = p == mEnd ? p : p + 1;
    return true;
}

tl::unexpected<Error> TextCursor::failExpected(const char *expected) const
{
    constexpr std::size_t MaxQuoted = 30; // enough to find the place, short enough for a message
    TextCursor here = *this;
    here.skipBlanks();
    std::string found;
    if (here.atEnd()) {
        found = QT_TRANSLATE_NOOP("ErrorText", "the end of the file");
    } else if (here.atLineEnd()) {
        found = QT_TRANSLATE_NOOP("ErrorText", "the end of the line");
    } else {
        found = "\"";
        for (const char c : here.token().substr(0, MaxQuoted))
            found += c > ' ' && c < '\x7f' ? c : '?';
        found += '"';
    }
    return failAtLine(mLine, ErrorCode::SyntaxError, expected, found);
}

} // namespace model::io
