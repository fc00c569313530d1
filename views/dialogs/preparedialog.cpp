// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/preparedialog.h"

#include "model/animation/settingsfields.h"
#include "model/io/errortext.h"
#include "views/dialogs/compressionfields.h"
#include "views/dialogs/framepreview.h"
#include "views/dialogs/framerates.h"
#include "views/dialogs/jobpanel.h"
#include "views/dialogs/normalisationchoice.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/pathfield.h"
#include "views/dialogs/qualitypanel.h"
#include "views/dialogs/quantitytext.h"
#include "views/dialogs/triespanel.h"

#include <QDir>
#include <QDropEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

namespace views {

using model::Normalisation;

namespace {

// Long enough not to read at every letter of a typed path, short enough not to be noticed.
constexpr int ReadDelayMilliseconds = 300;

enum Fact { Format, Frames, Vertices, Triangles, BoxSize, RawSize };

/// Beside the source, and never the source itself.
QString proposedOutputFor(const FoundSource &found)
{
    const QFileInfo info(found.path);
    const QString stem = info.isDir() ? info.fileName() : info.completeBaseName();
    QDir folder(info.absolutePath());
    if (!QFileInfo(folder.path()).isWritable())
        folder = QDir::home();
    const QString ending = found.kind == SourceKind::Encoded ? QStringLiteral("-2.anim") : QStringLiteral(".anim");
    return folder.filePath((stem.isEmpty() ? QStringLiteral("animation") : stem) + ending);
}

} // namespace

PrepareDialog::PrepareDialog(QWidget *parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Prepare Animation"));
    setObjectName(QStringLiteral("prepareDialog"));
    setAcceptDrops(true);
    setSizeGripEnabled(true);

    auto *column = new QVBoxLayout(this);
    column->addWidget(makeSourcePart());
    auto *middle = new QHBoxLayout;
    mSettingsPart = makeSettingsPart();
    middle->addWidget(mSettingsPart, 2);
    middle->addWidget(makeFoundPart(), 3);
    column->addLayout(middle, 3);
    auto *qualityPart = new QGroupBox(tr("Size and Error"), this);
    mQuality = new QualityPanel(qualityPart);
    (new QVBoxLayout(qualityPart))->addWidget(mQuality);
    column->addWidget(qualityPart, 2);
    mTriesPart = new QGroupBox(tr("Results"), this);
    mTries = new TriesPanel(mTriesPart);
    (new QVBoxLayout(mTriesPart))->addWidget(mTries);
    mTriesPart->hide();
    column->addWidget(mTriesPart, 2);
    column->addWidget(makeButtons());

    mReadDelay.setSingleShot(true);
    mReadDelay.setInterval(ReadDelayMilliseconds);
    connect(&mReadDelay, &QTimer::timeout, this, &PrepareDialog::readSourceNow);
    connect(&mReading, &Job::progressed, this, [this] { showReading(mReading.isRunning()); });
    connect(mQuality, &QualityPanel::settingsFound, this, [this](const model::CompressionSettings &settings) {
        const QSignalBlocker blocker(mCompression);
        mCompression->setSettings(settings);
        showResolutionMeaning();
        updateEncodeButton();
    });
    connect(mTries, &TriesPanel::openRequested, this, &PrepareDialog::openRequested);
    connect(mTries, &TriesPanel::encodeAgainRequested, this, &PrepareDialog::encodeAgain);
    connect(&mEncoding, &Job::runningChanged, this, [this](bool running) {
        mSource->setEnabled(!running);
        mSettingsPart->setEnabled(!running);
        mOutput->setEnabled(!running);
        mQuality->setEnabled(!running);
        updateEncodeButton();
    });

    restoreSettings();
    sourceEdited();
    resize(1040, 760);
    mSource->setFocus();
}

PrepareDialog::~PrepareDialog()
{
    saveSettings();
    // A field that loses the focus on its way out must not reach a dialog that is half gone.
    const QList<QWidget *> parts = findChildren<QWidget *>();
    for (QWidget *part : parts)
        part->disconnect(this);
}

QWidget *PrepareDialog::makeSourcePart()
{
    auto *part = new QWidget(this);
    part->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    mSourceForm = new QFormLayout(part);
    mSourceForm->setContentsMargins(0, 0, 0, 0);
    mSource = new PathField(tr("Source"), PathField::ExistingFolder | PathField::ExistingFile, part);
    mSource->setObjectName(QStringLiteral("source"));
    mSource->setFileFilter(sourceFileFilter());
    mSource->input().setPlaceholderText(tr("Folder of frames, point cache or scene: type, drop or browse"));
    mBaseMesh = new PathField(tr("Base Mesh"), PathField::ExistingFile, part);
    mBaseMesh->setObjectName(QStringLiteral("baseMesh"));
    mBaseMesh->input().setPlaceholderText(tr("The mesh of the same name beside the point cache"));
    mBakeRate = new NumberField(tr("Bake at"), FrameRates, part);
    mBakeRate->setObjectName(QStringLiteral("bakeRate"));
    mBakeRate->setHint(tr("frames per second"));
    mBakeRate->setValue(25);
    mAnimation = new QSpinBox(part);
    mAnimation->setObjectName(QStringLiteral("animation"));
    mAnimation->setAccessibleName(tr("Animation of the scene"));
    mAnimation->setRange(1, 9999);
    mAnimation->setToolTip(tr("For scenes that hold several animations"));
    mAnimation->setMaximumWidth(110);
    mSourceMessage = new HintLabel(part);
    mSourceMessage->setObjectName(QStringLiteral("sourceMessage"));
    mSourceMessage->setWordWrap(true);
    mSourceForm->addRow(tr("&Source:"), mSource);
    mSourceForm->addRow(tr("Base &mesh:"), mBaseMesh);
    mSourceForm->addRow(tr("Ba&ke at:"), mBakeRate);
    mSourceForm->addRow(tr("Anima&tion:"), mAnimation);
    mSourceForm->addRow(QString(), mSourceMessage);

    connect(mSource, &PathField::pathChanged, this, &PrepareDialog::sourceEdited);
    connect(mBaseMesh, &PathField::pathChanged, this, &PrepareDialog::sourceEdited);
    connect(mBakeRate, &NumberField::changed, this, &PrepareDialog::sourceEdited);
    connect(mAnimation, &QSpinBox::valueChanged, this, &PrepareDialog::sourceEdited);
    for (PathField *field : {mSource, mBaseMesh})
        connect(field, &PathField::pathChosen, this, [this] {
            if (mReadDelay.isActive())
                readSourceNow();
        });
    return part;
}

QWidget *PrepareDialog::makeSettingsPart()
{
    auto *part = new QGroupBox(tr("Settings"), this);
    auto *form = new QFormLayout(part);
    mName = new QLineEdit(part);
    mName->setObjectName(QStringLiteral("name"));
    mName->setAccessibleName(tr("Name"));
    mFrameRate = new NumberField(tr("Frame rate"), FrameRates, part);
    mFrameRate->setObjectName(QStringLiteral("frameRate"));
    mFrameRate->setHint(tr("frames per second"));
    mFrameRate->setValue(25);
    mNormalisation = new NormalisationChoice(part);
    form->addRow(tr("&Name:"), mName);
    form->addRow(tr("Frame &rate:"), mFrameRate);
    form->addRow(tr("Normalis&e:"), mNormalisation);
    mCompression = new CompressionFields(*form, this);

    connect(mFrameRate, &NumberField::changed, this, &PrepareDialog::updateEncodeButton);
    connect(mNormalisation, &QComboBox::currentIndexChanged, this, [this] {
        showResolutionMeaning();
        mQuality->setAnimation(mFound ? mFound->frames : nullptr, mNormalisation->mode());
    });
    connect(mCompression, &CompressionFields::changed, this, [this] {
        showResolutionMeaning();
        tellQuality();
        updateEncodeButton();
    });
    return part;
}

QWidget *PrepareDialog::makeFoundPart()
{
    auto *part = new QGroupBox(tr("Found"), this);
    auto *row = new QHBoxLayout(part);
    auto *facts = new QFormLayout;
    facts->setFormAlignment(Qt::AlignLeft | Qt::AlignTop);
    const QString names[] = {tr("Format:"),    tr("Frames:"), tr("Vertices:"),
                             tr("Triangles:"), tr("Box:"),    tr("Raw size:")};
    const char *objectNames[] = {"factFormat", "factFrames", "factVertices", "factTriangles", "factBox", "factRawSize"};
    for (int i = 0; i < 6; ++i) {
        mFacts[i] = new QLabel(part);
        mFacts[i]->setObjectName(QLatin1String(objectNames[i]));
        mFacts[i]->setTextInteractionFlags(Qt::TextSelectableByMouse);
        mFacts[i]->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("Folder of OBJ frames")));
        facts->addRow(names[i], mFacts[i]);
    }
    mFacts[RawSize]->setToolTip(tr("The positions alone, as 32-bit numbers"));
    mPreview = new FramePreview(part);
    row->addLayout(facts);
    row->addWidget(mPreview, 1);
    return part;
}

QWidget *PrepareDialog::makeButtons()
{
    auto *part = new QWidget(this);
    auto *form = new QFormLayout;
    mOutput = new PathField(tr("Output File"), PathField::NewFile, part);
    mOutput->setObjectName(QStringLiteral("output"));
    mOutput->setFileFilter(tr("Encoded Animations (%1)").arg(QStringLiteral("*.anim")));
    form->addRow(tr("&Output file:"), mOutput);
    mEncodingPanel = new JobPanel(mEncoding, part);
    mEncodingPanel->setActivity(tr("Encoding…"));
    mMessage = new HintLabel(part);
    mMessage->setObjectName(QStringLiteral("message"));
    mMessage->setWordWrap(true);
    mEncode = new QPushButton(tr("En&code"), part);
    mEncode->setObjectName(QStringLiteral("encode"));
    mEncode->setDefault(true);
    auto *close = new QPushButton(tr("Close"), part);
    close->setObjectName(QStringLiteral("close"));
    close->setAutoDefault(false);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(mMessage, 1);
    buttons->addWidget(mEncode);
    buttons->addWidget(close);
    auto *column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(form);
    column->addWidget(mEncodingPanel);
    column->addLayout(buttons);

    connect(mOutput, &PathField::pathChanged, this, &PrepareDialog::updateEncodeButton);
    connect(mEncode, &QPushButton::clicked, this, &PrepareDialog::encode);
    connect(close, &QPushButton::clicked, this, &PrepareDialog::reject);
    return part;
}

void PrepareDialog::restoreSettings()
{
    QSettings settings;
    settings.beginGroup(QStringLiteral("prepareDialog"));
    const auto within = [](double value, double min, double max, double otherwise) {
        return value >= min && value <= max ? value : otherwise; // also for what is not a number
    };
    const std::string compression = settings.value(QStringLiteral("compression")).toString().toStdString();
    mCompression->setSettings(model::settingsFromText(compression).value_or(model::CompressionSettings()));
    mNormalisation->setMode(Normalisation(settings.value(QStringLiteral("normalisation")).toInt()));
    mBakeRate->setValue(
        within(settings.value(QStringLiteral("bakeRate"), 25).toDouble(), FrameRates.min, FrameRates.max, 25));
    const QString folder = settings.value(QStringLiteral("folder"), QDir::homePath()).toString();
    mSource->setStartFolder(folder);
    mBaseMesh->setStartFolder(folder);
    restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
}

void PrepareDialog::saveSettings() const
{
    QSettings settings;
    settings.beginGroup(QStringLiteral("prepareDialog"));
    if (mCompression->problem().isEmpty())
        settings.setValue(QStringLiteral("compression"),
                          QString::fromStdString(model::settingsText(mCompression->settings())));
    settings.setValue(QStringLiteral("normalisation"), int(mNormalisation->mode()));
    if (mBakeRate->value())
        settings.setValue(QStringLiteral("bakeRate"), *mBakeRate->value());
    if (mFound)
        settings.setValue(QStringLiteral("folder"), QFileInfo(mFound->path).absolutePath());
    settings.setValue(QStringLiteral("geometry"), saveGeometry());
}

void PrepareDialog::setSource(const QString &path)
{
    mSource->setPath(path);
    readSourceNow();
}

void PrepareDialog::dragEnterEvent(QDragEnterEvent *event)
{
    if (!isEncoding() && !droppedPath(event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void PrepareDialog::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    setSource(droppedPath(event->mimeData()));
}

void PrepareDialog::sourceEdited()
{
    // What is shown must never be of another source than the one in the field.
    mReading.cancel();
    mFound.reset();
    mQuality->setAnimation(nullptr, mNormalisation->mode());
    for (QLabel *fact : mFacts)
        fact->setText(QStringLiteral("–"));
    mPreview->clear(tr("The first frame is shown here."));
    const QString path = mSource->path();
    const SourceKind kind = sourceKindOf(path);
    mSourceForm->setRowVisible(mBaseMesh, kind == SourceKind::PointCache);
    mSourceForm->setRowVisible(mBakeRate, kind == SourceKind::Scene);
    mSourceForm->setRowVisible(mAnimation, kind == SourceKind::Scene);

    mSource->input().setRefused(false);
    mBaseMesh->input().setRefused(false);
    mSourceForm->setRowVisible(mSourceMessage, false);
    mReadDelay.start();
    updateEncodeButton();
}

void PrepareDialog::readSourceNow()
{
    mReadDelay.stop();
    const QString path = mSource->path();
    if (path.isEmpty())
        return;
    const SourceKind kind = sourceKindOf(path);
    if (const QString problem = sourceProblem(path); !problem.isEmpty()) {
        mSource->input().setRefused(true);
        mSourceMessage->showRefusal(problem);
        mSourceForm->setRowVisible(mSourceMessage, true);
        updateEncodeButton();
        return;
    }
    model::io::ReadOptions options;
    if (kind == SourceKind::PointCache)
        options.baseMesh = mBaseMesh->path();
    if (kind == SourceKind::Scene) {
        if (!mBakeRate->value())
            return;
        options.frameRate = *mBakeRate->value();
        options.animationIndex = mAnimation->value() - 1;
    }
    mReading.start([path, options](const model::Progress &progress) { return readSource(path, options, progress); },
                   [this, path](model::Result<FoundSource> result) {
                       // A source that was read to its end may have left the field a moment before.
                       if (path == mSource->path() && !mReadDelay.isActive())
                           showFound(std::move(result));
                   });
    showReading(true);
}

void PrepareDialog::showReading(bool running)
{
    if (running)
        mPreview->clear(tr("Reading… %1 %").arg(int(100 * mReading.fraction())));
    updateEncodeButton();
}

void PrepareDialog::showFound(model::Result<FoundSource> result)
{
    if (!result) {
        mPreview->clear({});
        if (result.error().code == model::ErrorCode::Cancelled)
            return; // another source is on its way
        const bool isBaseMesh = result.error().code == model::ErrorCode::MissingBaseMesh;
        (isBaseMesh ? mBaseMesh : mSource)->input().setRefused(true);
        mSourceMessage->showRefusal(model::io::errorText(result.error()));
        mSourceForm->setRowVisible(mSourceMessage, true);
        updateEncodeButton();
        return;
    }
    mFound = std::move(*result);
    if (mFound->path != mTriedSource) {
        // Tries compare settings, not animations; and a file made of another source is asked about before it goes.
        mTries->clear();
        mTriesPart->hide();
        mTriedSource = mFound->path;
    }
    const model::FrameSource &frames = *mFound->frames;
    const double seconds = frames.frameCount() / frames.frameRate();
    mFacts[Format]->setText(mFound->format);
    mFacts[Frames]->setText(tr("%1 (%2)").arg(countText(frames.frameCount()), durationText(seconds)));
    mFacts[Vertices]->setText(countText(frames.vertexCount()));
    mFacts[Triangles]->setText(countText(frames.connectivity().triangles.size()));
    const model::Vec3f size = mFound->box.size();
    mFacts[BoxSize]->setText(
        QStringLiteral("%1 × %2 × %3").arg(significantText(size.x), significantText(size.y), significantText(size.z)));
    const auto point = [](model::Vec3f p) {
        return QStringLiteral("(%1; %2; %3)").arg(significantText(p.x), significantText(p.y), significantText(p.z));
    };
    mFacts[BoxSize]->setToolTip(
        tr("All frames together, from %1 to %2").arg(point(mFound->box.min), point(mFound->box.max)));
    mFacts[RawSize]->setText(bytesText(mFound->rawBytes()));
    mPreview->setFrames(mFound->frames, mFound->box);
    tellQuality();
    mQuality->setAnimation(mFound->frames, mNormalisation->mode());

    // Proposals give way to the next source's, unless the user wrote something else.
    if (mName->text() == mProposedName)
        mName->setText(mProposedName = frames.name().empty() ? QFileInfo(mFound->path).completeBaseName()
                                                             : QString::fromStdString(frames.name()));
    if (!mFrameRate->value() || *mFrameRate->value() == mProposedRate || mProposedRate == 0)
        mFrameRate->setValue(mProposedRate = frames.frameRate());
    proposeOutput();
    showResolutionMeaning();
    updateEncodeButton();
}

void PrepareDialog::proposeOutput()
{
    if (!mOutput->path().isEmpty() && mOutput->path() != mProposedOutput)
        return;
    mProposedOutput = proposedOutputFor(*mFound);
    mOutput->setPath(mProposedOutput);
}

void PrepareDialog::showResolutionMeaning()
{
    if (mCompression->settings().codec() != model::CodecId::Pca)
        return;
    NumberField &field = *mCompression->numberField("resolution");
    const std::optional<double> resolution = field.value();
    // Normalising makes the longest side 2 (for the first frame alone: about that).
    const double longest = mNormalisation->mode() != Normalisation::None ? 2
                           : mFound                                      ? double(mFound->box.longestSide())
                                                                         : 0;
    field.setHint(resolution && longest > 0
                      ? tr("one step: %1 % of the longest side").arg(significantText(100 / *resolution / longest))
                      : tr("steps per unit of length"));
}

void PrepareDialog::tellQuality()
{
    mQuality->setSettings(mCompression->problem().isEmpty() ? std::optional(mCompression->settings()) : std::nullopt);
}

QString PrepareDialog::problem() const
{
    if (mSource->path().isEmpty())
        return tr("Choose a source.");
    if (mReading.isRunning() || mReadDelay.isActive())
        return tr("The source is being read.");
    if (!mFound)
        return !mBakeRate->problem().isEmpty() && mBakeRate->isVisibleTo(this) ? mBakeRate->problem()
                                                                               : tr("The source cannot be read.");
    if (!mFrameRate->problem().isEmpty())
        return mFrameRate->problem();
    if (!mCompression->problem().isEmpty())
        return mCompression->problem();
    return newFileProblem(outputPath());
}

QString PrepareDialog::outputPath() const
{
    return withEnding(mOutput->path(), QStringLiteral(".anim"));
}

void PrepareDialog::updateEncodeButton()
{
    const QString reason = problem();
    const bool outputIsWrong =
        mFound && mFrameRate->problem().isEmpty() && mCompression->problem().isEmpty() && !reason.isEmpty();
    mOutput->input().setRefused(outputIsWrong);
    mEncode->setEnabled(reason.isEmpty() && !isEncoding());
    mEncode->setToolTip(reason);
    if (isEncoding())
        mMessage->showHint({});
    else if (reason.isEmpty() && QFileInfo::exists(outputPath()) && !mTries->hasWritten(outputPath()))
        mMessage->showHint(tr("The output file exists. You will be asked before it is replaced."));
    else
        mMessage->showHint(reason);
}

bool PrepareDialog::mayOverwrite(const QString &output)
{
    if (!QFileInfo::exists(output) || mTries->hasWritten(output))
        return true;
    QMessageBox question(QMessageBox::Question, windowTitle(),
                         tr("“%1” exists. Replace it?").arg(QFileInfo(output).fileName()), QMessageBox::Cancel, this);
    const QPushButton *replace = question.addButton(tr("Replace"), QMessageBox::AcceptRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    return question.clickedButton() == replace;
}

void PrepareDialog::encode()
{
    const QString output = outputPath();
    if (!problem().isEmpty() || isEncoding() || !mayOverwrite(output))
        return;
    saveSettings();
    mQuality->stop();
    const EncodingOrder order{mFound->frames, mNormalisation->mode(),   *mFrameRate->value(),
                              mName->text(),  mCompression->settings(), output};
    mEncoding.start([order](const model::Progress &progress) { return encodeToFile(order, progress); },
                    [this](model::Result<EncodingReport> result) { showEncoded(std::move(result)); });
}

void PrepareDialog::showEncoded(model::Result<EncodingReport> result)
{
    if (result) {
        if (!mTriesPart->isVisibleTo(this)) {
            mTriesPart->show();
            constexpr int TitleBar = 40;
            const int room = screen()->availableGeometry().height() - TitleBar;
            resize(width(), qMin(room, qMax(height(), sizeHint().height())));
        }
        mTries->add(*result);
        mQuality->addTrial({result->order.settings.method, result->fileBytes, result->errors.kgErrorPercent});
        updateEncodeButton();
        return;
    }
    if (result.error().code == model::ErrorCode::Cancelled)
        mMessage->showHint(tr("Cancelled. Nothing was written."));
    else
        mMessage->showRefusal(model::io::errorText(result.error()));
}

void PrepareDialog::encodeAgain()
{
    QWidget *field = mCompression->firstField();
    field->setFocus();
    if (const auto *number = qobject_cast<NumberField *>(field))
        number->input().selectAll();
}

void PrepareDialog::reject()
{
    if (isEncoding()) {
        QMessageBox question(QMessageBox::Question, windowTitle(), tr("The animation is still being encoded."),
                             QMessageBox::NoButton, this);
        const QPushButton *stop = question.addButton(tr("Stop Encoding"), QMessageBox::DestructiveRole);
        question.setDefaultButton(question.addButton(tr("Keep Encoding"), QMessageBox::RejectRole));
        question.exec();
        if (question.clickedButton() != stop)
            return;
        mEncoding.cancel();
    }
    saveSettings();
    QDialog::reject();
}

} // namespace views
