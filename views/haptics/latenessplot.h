// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/servo/histogram.h"

#include <QWidget>

#include <array>

namespace views {

/// How late the steps of the servo began: how many by how much, on logarithmic axes, with a mark at the time that 99 of
/// 100 kept.
class LatenessPlot final : public QWidget
{
    Q_OBJECT

public:
    explicit LatenessPlot(QWidget *parent = nullptr);

    /// Counts what is in it now. null: nothing
    void setLateness(const model::haptics::Histogram *lateness);
    /// How many fell into a bar.
    std::uint64_t countIn(int bar) const { return mBars[std::size_t(bar)]; }
    static constexpr int BarCount = 50;
    /// The bar of a span of time: ten for each power of ten, from 1 us to 100 ms, those beyond at the ends.
    static int barOf(model::haptics::Time lateness);

    QSize sizeHint() const override { return {260, 96}; }
    QSize minimumSizeHint() const override { return {180, 80}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    std::array<std::uint64_t, BarCount> mBars{};
    model::haptics::Time mMost{0}; ///< 99 of 100 were no later
};

} // namespace views
