// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/compressiondock.h"

#include "commands/animation/setcompression.h"
#include "model/io/animfile.h"
#include "model/io/errortext.h"
#include "views/dialogs/compressionfields.h"
#include "views/dialogs/inputline.h"
#include "views/dialogs/jobpanel.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"

#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace views {

namespace {

QString ratioText(double ratio)
{
    return ratio > 0 ? QStringLiteral("%1 : 1").arg(numberText(ratio, ratio < 10 ? 1 : 0)) : QStringLiteral("–");
}

} // namespace

CompressionDock::CompressionDock(QWidget *parent)
    : QDockWidget(parent)
{
    setObjectName(QStringLiteral("compressionDock"));
    build();
}

CompressionDock::~CompressionDock() = default;

void CompressionDock::setDocument(commands::AnimationContext *context, const std::optional<FileFacts> &facts)
{
    mFacts = facts;
    if (mContext != context) {
        disconnect(mChanges);
        mMeasuring.cancel();
        mMeasurement.reset();
        mContext = context;
        if (context) {
            mGesture = context->newGesture();
            mChanges = connect(&context->document(), &model::AnimationDocument::changed, this, [this] {
                mMeasurement.reset(); // of what the animation was before
                showSettings();
                showMeasurement();
            });
        }
    }
    showSettings();
    showFacts();
    showMeasurement();
}

void CompressionDock::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        build();
    QDockWidget::changeEvent(event);
}

void CompressionDock::build()
{
    setWindowTitle(tr("Compression"));
    auto *scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus); // the fields in it have the focus
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->addWidget(makeSettingsPart(content));
    column->addWidget(makeMeasurePart(content));
    column->addWidget(makeFilePart(content), 1);
    column->addStretch();
    scroll->setWidget(content);
    scroll->setMinimumWidth(content->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    QWidget *before = widget();
    setWidget(scroll);
    delete before;
    showSettings();
    showFacts();
    showMeasurement();
}

QWidget *CompressionDock::makeSettingsPart(QWidget *parent)
{
    auto *part = new QGroupBox(tr("When Saved"), parent);
    auto *form = new QFormLayout(part);
    form->setRowWrapPolicy(QFormLayout::DontWrapRows);
    mSettingsPart = part;
    mFields = new CompressionFields(*form, part);
    // A dock is narrow: no remarks, and a refusal may take several lines.
    for (NumberField *field : mFields->numberFields())
        field->setHint(QString());
    for (HintLabel *hint : part->findChildren<HintLabel *>())
        hint->setWordWrap(true);
    connect(mFields, &CompressionFields::changed, this, &CompressionDock::editSettings);
    // Steps that follow one another in one field are one step of the history; leaving the field ends it.
    for (NumberField *field : mFields->numberFields())
        connect(&field->input(), &QLineEdit::editingFinished, this, [this] {
            if (mContext)
                mGesture = mContext->newGesture();
        });
    return part;
}

QWidget *CompressionDock::makeMeasurePart(QWidget *parent)
{
    auto *part = new QWidget(parent);
    auto *column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    mMeasure = new QPushButton(tr("&Measure Size and Error"), part);
    mMeasure->setObjectName(QStringLiteral("measure"));
    mMeasure->setToolTip(tr("Compress with these settings, without saving, and compare the result with the animation"));
    connect(mMeasure, &QPushButton::clicked, this, &CompressionDock::measure);
    mMeasured = new HintLabel(part);
    mMeasured->setObjectName(QStringLiteral("measured"));
    mMeasured->setWordWrap(true);
    auto *panel = new JobPanel(mMeasuring, part);
    panel->setActivity(tr("Measuring…"));
    panel->setVisible(mMeasuring.isRunning());
    connect(&mMeasuring, &Job::runningChanged, panel, &QWidget::setVisible);
    connect(&mMeasuring, &Job::runningChanged, mMeasure, [this] { showMeasurement(); });
    column->addWidget(mMeasure);
    column->addWidget(panel);
    column->addWidget(mMeasured);
    return part;
}

QWidget *CompressionDock::makeFilePart(QWidget *parent)
{
    auto *part = new QGroupBox(tr("File"), parent);
    mFilePart = part;
    auto *column = new QVBoxLayout(part);
    auto *form = new QFormLayout;
    const QString names[] = {tr("Size:"),           tr("As float32:"),    tr("Ratio:"),
                             tr("Bits per V × F:"), tr("Basis vectors:"), tr("Written by:")};
    for (std::size_t i = 0; i < std::size(mFactValues); ++i) {
        mFactValues[i] = new QLabel(part);
        mFactValues[i]->setTextInteractionFlags(Qt::TextSelectableByMouse);
        form->addRow(names[i], mFactValues[i]);
    }
    mFactValues[3]->setToolTip(tr("Bits for each vertex of each frame, everything in the file included"));
    mFactValues[4]->setToolTip(tr("Basis vectors kept; an animation of lower rank keeps fewer than asked for"));
    column->addLayout(form);
    mChunks = new QTreeWidget(part);
    mChunks->setObjectName(QStringLiteral("chunks"));
    mChunks->setAccessibleName(tr("Parts of the file"));
    mChunks->setHeaderLabels({tr("Part"), tr("Bytes"), tr("Share")});
    mChunks->setRootIsDecorated(false);
    mChunks->setUniformRowHeights(true);
    mChunks->setAlternatingRowColors(true);
    mChunks->setMinimumHeight(80);
    for (const int column_ : {1, 2})
        mChunks->headerItem()->setTextAlignment(column_, Qt::AlignRight);
    mChunks->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    column->addWidget(mChunks, 1);
    return part;
}

void CompressionDock::editSettings()
{
    if (!mContext || !mFields->problem().isEmpty())
        return;
    mContext->push<commands::SetCompression>(mFields->settings(), mGesture);
}

void CompressionDock::showSettings()
{
    mSettingsPart->setEnabled(mContext);
    if (!mContext)
        return;
    const model::CompressionSettings &settings = mContext->document().compression();
    // What is being typed stays as it was typed.
    if (!mFields->problem().isEmpty() || mFields->settings() != settings) {
        const QSignalBlocker blocker(mFields);
        mFields->setSettings(settings);
    }
}

void CompressionDock::showFacts()
{
    mFilePart->setVisible(mFacts.has_value());
    if (!mFacts)
        return;
    const FileFacts &facts = *mFacts;
    const QString values[] = {bytesText(facts.bytes),     bytesText(facts.rawBytes()),
                              ratioText(facts.ratio()),   numberText(facts.bitsPerVertexFrame(), 3),
                              countText(facts.basisSize), QString::fromStdString(facts.creator)};
    for (std::size_t i = 0; i < std::size(mFactValues); ++i)
        mFactValues[i]->setText(values[i]);
    mChunks->clear();
    for (const model::codec::ChunkInfo &chunk : facts.chunks) {
        auto *row = new QTreeWidgetItem(
            mChunks, {QString::fromStdString(chunk.tag), countText(chunk.bytes),
                      tr("%1 %").arg(numberText(100.0 * double(chunk.bytes) / double(facts.bytes), 1))});
        row->setTextAlignment(1, Qt::AlignRight);
        row->setTextAlignment(2, Qt::AlignRight);
    }
}

void CompressionDock::showMeasurement()
{
    mMeasure->setEnabled(mContext && !mMeasuring.isRunning());
    mMeasure->setVisible(!mMeasuring.isRunning());
    mMeasured->setVisible(mMeasurement.has_value());
    if (!mMeasurement)
        return;
    const Measurement &m = *mMeasurement;
    mMeasured->showHint(tr("%1, ratio %2, %3 bits per vertex and frame\nKG error %4 %, RMSE %5, largest error %6")
                            .arg(bytesText(m.bytes), ratioText(double(m.rawBytes) / double(m.bytes)),
                                 numberText(m.bitsPerVertexFrame, 3), significantText(m.errors.kgErrorPercent),
                                 significantText(m.errors.rmse), significantText(m.errors.maxVertexError)));
}

model::Result<CompressionDock::Measurement> CompressionDock::measured(const model::FrameSource &frames,
                                                                      const model::CompressionSettings &settings,
                                                                      const model::Progress &progress)
{
    auto encoded = model::codec::encodeAnimation(frames, settings, progress.part(0, 0.7));
    if (!encoded)
        return model::fail(std::move(encoded.error()));
    const auto limits = model::codec::DecodeLimits::ofThisMachine(encoded->bytes.size());
    const auto decoded = model::codec::decodeAnimation(std::move(encoded->bytes), progress.part(0.7, 0.75), limits);
    if (!decoded)
        return model::fail(decoded.error());
    auto errors = model::compareAnimations(frames, **decoded, encoded->permutation, progress.part(0.75, 1));
    if (!errors)
        return model::fail(std::move(errors.error()));
    const FileFacts facts = factsOf(**decoded);
    return Measurement{facts.bytes, facts.rawBytes(), facts.bitsPerVertexFrame(), std::move(*errors)};
}

void CompressionDock::measure()
{
    const model::AnimationDocument &document = mContext->document();
    mMeasuring.start([frames = document.frames(), settings = document.compression()](
                         const model::Progress &progress) { return measured(*frames, settings, progress); },
                     [this, context = mContext, settings = document.compression(),
                      frames = document.frames()](model::Result<Measurement> result) {
                         showMeasurement();
                         if (!result) {
                             if (result.error().code != model::ErrorCode::Cancelled) {
                                 mMeasured->setVisible(true);
                                 mMeasured->showRefusal(model::io::errorText(result.error()));
                             }
                             return;
                         }
                         // Of another document, or of what it was before an edit: nobody's answer any more.
                         if (!mContext || context != mContext || mContext->document().frames() != frames ||
                             mContext->document().compression() != settings)
                             return;
                         mMeasurement = std::move(*result);
                         showMeasurement();
                     });
}

} // namespace views
