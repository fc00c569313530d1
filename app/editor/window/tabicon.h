// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace editor {

class Document;

/// What a tab says without words: a ring that fills while the document is being opened or saved, a dot while it has
/// unsaved changes, else nothing.
QIcon tabIcon(Document &document);

} // namespace editor
