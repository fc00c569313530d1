// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/normalisation.h"
#include "views/scene/comparison.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QPushButton;

namespace views {

/// Reads an original for a Comparison, in its worker. Errors as model::io::readAnimation.
using OriginalReader = std::function<model::Result<Original>(const model::Progress &)>;
OriginalReader originalReader(const QString &path, model::Normalisation mode);

class HintLabel;
class NormalisationChoice;
class PathField;

/// Asks for the original of an animation: another one that is open, or a file or folder.
class CompareDialog final : public QDialog
{
    Q_OBJECT

public:
    struct Candidate
    {
        QString name;
        model::FrameSourcePtr frames;
    };

    /// \param title       the animation's
    /// \param candidates  open animations with as many frames and vertices
    CompareDialog(const QString &title, std::vector<Candidate> candidates, const QString &startFolder,
                  QWidget *parent = nullptr);

    /// What was chosen. Precondition: accepted.
    QString originalName() const;
    OriginalReader reader() const;

private:
    bool isFileChosen() const;
    void follow();

    const std::vector<Candidate> mCandidates;
    QComboBox *mOriginal;
    PathField *mPath;
    NormalisationChoice *mNormalisation;
    HintLabel *mHint;
    QPushButton *mCompare;
};

} // namespace views
