// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include <QObject>
#include <QThreadPool>

#include "core/recording/Recording.h"
#include "lessons/GridSensitivity.h"
#include "lessons/PointLossTimeline.h"

namespace ui::scoring {
class ScorePage;
}

namespace app {

/// Finds out in the background what a score does not say by itself, on one thread of low priority. Its owner's thread;
/// signals come there.
class ScoreAnalysis final : public QObject
{
    Q_OBJECT
public:
    explicit ScoreAnalysis(QObject* parent = nullptr);
    ~ScoreAnalysis() override;

    /// Begins with another attempt; what goes on about the one before is left off.
    /// @param tooth, conduct  as it ended, and how it went
    void explain(const lessons::Assignment& assignment, const core::recording::Recording& recording,
                 std::shared_ptr<const core::terrain::Tooth> tooth, const lessons::Conduct& conduct);
    /// Says again what has been found so far.
    void tellAgain();
    /// Leaves off; what was found is forgotten.
    void forget();
    /// Shows on the score page what is found, as it is found.
    /// @param isShown  whether the page shows the attempt that this is about; findings are dropped while it does not
    void showOn(ui::scoring::ScorePage& page, const std::function<bool()>& isShown);

signals:
    void noiseFound(const lessons::GridSensitivity& noise);
    void momentsProgress(double share);
    void momentsFound(const lessons::PointLossTimeline& moments);
    void failed(const core::Error& error);

private:
    void takeNoise(const core::Result<lessons::GridSensitivity>& found);
    void takeMoments(const core::Result<std::optional<lessons::PointLossTimeline>>& found);

    QThreadPool m_pool;
    std::shared_ptr<std::atomic<bool>> m_goOn;  ///< of the attempt that is looked at; null: none
    double m_share = 0.0;
    std::optional<lessons::GridSensitivity> m_noise;
    std::optional<lessons::PointLossTimeline> m_moments;
};

}  // namespace app
