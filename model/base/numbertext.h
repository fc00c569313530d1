// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string>

namespace model {

/// Appends the shortest text that reads back as the same number; no locale.
template <class Number>
void appendNumber(std::string &out, Number value)
{
    char text[32];
    out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// The same as a text of its own, as it stands in an error's args.
template <class Number>
std::string numberText(Number value)
{
    std::string text;
    appendNumber(text, value);
    return text;
}

} // namespace model
