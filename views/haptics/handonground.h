// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/groundinteraction.h"

#include <QObject>

#include <optional>

namespace views {

class HapticsSession;

/// The hand at the simulated device: the mouse, a pen or the arrow keys move it over the ground, the wheel or Page Up
/// and Page Down lift it and press it in, the left button or Space is the device's button. Ctrl and the wheel zoom.
class HandOnGround final : public QObject, public GroundInteraction
{
    Q_OBJECT

public:
    explicit HandOnGround(HapticsSession &session, QObject *parent = nullptr);

    /// Metres of the hand above the ground; below 0 it is pressed in.
    double height() const { return mHeight; }
    void setHeight(double height);

    bool isActive() const override { return true; }
    bool press(const GroundEvent &event) override;
    void move(const GroundEvent &event) override;
    void release(const GroundEvent &event) override;
    void cancel() override;
    void hover(const GroundEvent &event) override;
    bool wheel(const GroundEvent &event, double notches) override;
    bool keyPress(const QKeyEvent &event) override;

signals:
    void heightChanged();

private:
    void send();

    HapticsSession &mSession;
    std::optional<model::terrain::Point3> mPlace; ///< on the ground
    double mHeight = 0.01;
    bool mIsPressed = false;
};

} // namespace views
