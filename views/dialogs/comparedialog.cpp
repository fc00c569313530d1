// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/comparedialog.h"

#include "model/animation/editedframes.h"
#include "views/dialogs/foundsource.h"
#include "views/dialogs/normalisationchoice.h"
#include "views/dialogs/pathfield.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QPushButton>

namespace views {

namespace {

constexpr double ReadAt = 0.8; ///< share of the progress

model::Result<Original> placed(model::FrameSourcePtr frames, model::Normalisation mode, const model::Progress &progress)
{
    const auto placement = model::normalisingSimilarity(*frames, mode, progress);
    if (!placement)
        return model::fail(placement.error());
    if (!placement->isIdentity())
        frames = std::make_shared<model::EditedFrames>(frames, model::TimeMap::identity(frames->frameCount()),
                                                       *placement, frames->frameRate(), frames->name());
    return Original{std::move(frames), {}};
}

} // namespace

OriginalReader originalReader(const QString &path, model::Normalisation mode)
{
    return [mode, path](const model::Progress &progress) -> model::Result<Original> {
        const auto frames = model::io::readAnimation(path, {}, progress.part(0, ReadAt));
        if (!frames)
            return model::fail(frames.error());
        return placed(*frames, mode, progress.part(ReadAt, 1));
    };
}

CompareDialog::CompareDialog(const QString &title, std::vector<Candidate> candidates, const QString &startFolder,
                             QWidget *parent)
    : QDialog(parent)
    , mCandidates(std::move(candidates))
    , mOriginal(new QComboBox)
    , mPath(new PathField(tr("Original"), PathField::ExistingFile | PathField::ExistingFolder))
    , mNormalisation(new NormalisationChoice)
    , mHint(new HintLabel)
{
    setObjectName(QStringLiteral("compareDialog"));
    setWindowTitle(tr("Compare %1 with Its Original").arg(title));
    mOriginal->setObjectName(QStringLiteral("original"));
    for (const Candidate &candidate : mCandidates)
        mOriginal->addItem(candidate.name);
    mOriginal->addItem(tr("A File or Folder"));
    mOriginal->setAccessibleName(tr("Original"));
    mPath->setObjectName(QStringLiteral("originalPath"));
    mPath->setFileFilter(sourceFileFilter());
    mPath->setStartFolder(startFolder);
    mPath->setMinimumWidth(380);
    mNormalisation->setObjectName(QStringLiteral("originalNormalisation"));
    mNormalisation->setMode(model::Normalisation::None);
    mNormalisation->setToolTip(
        tr("As was done when the animation was prepared: the original is moved and scaled alike"));

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    mCompare = buttons->addButton(tr("Compare"), QDialogButtonBox::AcceptRole);
    mCompare->setObjectName(QStringLiteral("compare"));
    mCompare->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto *form = new QFormLayout(this);
    form->addRow(tr("&Original:"), mOriginal);
    form->addRow(tr("&Path:"), mPath);
    form->addRow(tr("&Normalise it:"), mNormalisation);
    form->addRow(mHint);
    form->addRow(buttons);
    connect(mOriginal, &QComboBox::currentIndexChanged, this, &CompareDialog::follow);
    connect(mPath, &PathField::pathChanged, this, &CompareDialog::follow);
    follow();
}

bool CompareDialog::isFileChosen() const
{
    return mOriginal->currentIndex() == int(mCandidates.size());
}

void CompareDialog::follow()
{
    const bool isFile = isFileChosen();
    mPath->setEnabled(isFile);
    const QString problem = isFile && !mPath->path().isEmpty() ? sourceProblem(mPath->path()) : QString();
    mPath->input().setRefused(!problem.isEmpty());
    if (!problem.isEmpty())
        mHint->showRefusal(problem);
    else
        mHint->showHint(tr("Frames and vertices must be as many, and in the same order."));
    mCompare->setEnabled(!isFile || (!mPath->path().isEmpty() && problem.isEmpty()));
}

QString CompareDialog::originalName() const
{
    return isFileChosen() ? QFileInfo(mPath->path()).fileName()
                          : mCandidates[std::size_t(mOriginal->currentIndex())].name;
}

OriginalReader CompareDialog::reader() const
{
    const model::Normalisation mode = mNormalisation->mode();
    if (isFileChosen())
        return originalReader(mPath->path(), mode);
    return [mode, frames = mCandidates[std::size_t(mOriginal->currentIndex())].frames](
               const model::Progress &progress) { return placed(frames, mode, progress); };
}

} // namespace views
