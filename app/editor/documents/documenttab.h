// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/document.h"

#include <QWidget>

#include <memory>

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedLayout;

namespace editor {

/// A tab's page: how far the opening is, then what each kind of document shows.
class DocumentTab : public QWidget
{
    Q_OBJECT

public:
    Document &document() { return *mDocument; }
    const Document &document() const { return *mDocument; }

protected:
    DocumentTab(std::unique_ptr<Document> document, QWidget *parent);

    /// The document is open, for the first time or anew. \returns what shows it; becomes a child
    virtual QWidget *page() = 0;
    void changeEvent(QEvent *event) override;

private:
    QWidget *makeOpeningPage();
    void showDocument();
    void retranslate();

    const std::unique_ptr<Document> mDocument;
    QStackedLayout *mPages;
    QLabel *mOpeningTitle = nullptr;
    QProgressBar *mOpeningBar = nullptr;
    QPushButton *mCancel = nullptr;
};

} // namespace editor
