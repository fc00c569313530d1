// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/groundinteraction.h"

#include <QObject>

#include <optional>

namespace views {

/// The line of a cross-section on the ground: drawn by a drag from one end to the other, or by dragging one of its ends
/// elsewhere. Changes nothing in the document.
class ProfileLine final : public QObject, public GroundInteraction
{
    Q_OBJECT

public:
    struct Ends
    {
        model::terrain::Point2 a, b; ///< local metres, may lie beside the terrain

        friend bool operator==(const Ends &, const Ends &) = default;
    };

    /// \param view  to be told when the line changes; may be null
    explicit ProfileLine(GroundView *view, QObject *parent = nullptr);

    const std::optional<Ends> &ends() const { return mEnds; }
    void setEnds(const std::optional<Ends> &ends);
    /// A mark on the line, so far from its first end, in metres.
    void setMark(std::optional<double> distance);
    /// Whether the line is seen while another interaction works.
    void setVisible(bool isVisible);

    bool isActive() const override { return true; }
    bool press(const GroundEvent &event) override;
    void move(const GroundEvent &event) override;
    void release(const GroundEvent &event) override;
    void cancel() override;
    void hover(const GroundEvent &event) override;
    void leave() override;
    std::vector<GroundLine> lines() const override;

signals:
    /// There is another line, or none.
    void changed();

private:
    enum class End { None, A, B };

    End endAt(const GroundEvent &event) const;
    void updateLines();

    GroundView *mView;
    std::optional<Ends> mEnds, mBefore;
    End mDragged = End::None;
    std::optional<double> mMark;
    std::optional<GroundEvent> mPointer;
    double mMetresPerPixel = 0; ///< where the pointer was last
    bool mIsVisible = true;
};

} // namespace views
