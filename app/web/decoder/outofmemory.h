// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace web {

/// Given by the page, which throws: what was under way ends, and with it this instance of the module.
[[noreturn]] __attribute__((import_module("page"), import_name("outOfMemory"))) void outOfMemory();

} // namespace web
