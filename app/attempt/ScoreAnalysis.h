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

/// Computes in the background how exact a score is and when its points were lost, on a pool thread of low priority. Ui
/// thread; signals are emitted there.
class ScoreAnalysis final : public QObject
{
    Q_OBJECT
public:
    explicit ScoreAnalysis(QObject* parent = nullptr);
    ~ScoreAnalysis() override;

    /// Starts to analyse an attempt. Cancels the analysis of the attempt before.
    /// @param tooth    the tooth at the end of the attempt
    /// @param conduct  the measures of the process
    void explain(const lessons::Assignment& assignment, const core::recording::Recording& recording,
                 std::shared_ptr<const core::terrain::Tooth> tooth, const lessons::Conduct& conduct);
    /// Emits the signals for all results so far again.
    void emitFound();
    /// Cancels the analysis and clears its results.
    void forget();
    /// Shows each result on the score page when it arrives.
    /// @param isShown  returns whether the page shows the analysed attempt; if not, results are not shown
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
    std::shared_ptr<std::atomic<bool>> m_goOn;  ///< false cancels the present analysis; null: there is none
    double m_share = 0.0;
    std::optional<lessons::GridSensitivity> m_noise;
    std::optional<lessons::PointLossTimeline> m_moments;
};

}  // namespace app
