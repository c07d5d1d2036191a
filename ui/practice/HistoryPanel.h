// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <QCache>
#include <QFrame>
#include <QImage>
#include <QSet>

#include "core/history/MomentId.h"
#include "core/session/SessionChannels.h"
#include "ui/practice/HistoryGraph.h"
#include "ui/render/Look.h"

class QLabel;
class QListView;

namespace ui::practice {
class HistoryModel;
}

namespace ui::practice {

/// Access to the undo history (core::session::SessionLoop). Ui thread.
struct HistorySource
{
    std::function<std::vector<core::history::MomentInfo>()> moments;
    /// Returns the top map at a moment, mm; empty if the moment is no longer stored.
    std::function<std::vector<float>(core::history::MomentId)> heights;
};

/// Shows the undo history over the tooth: for each moment a small picture, its time and the removed material. Branches
/// are side by side, and the current moment is marked. A click or Enter goes to a moment. Worker threads draw a picture
/// when its row is first visible. The newest kMostPictures are cached, about 6 KB each.
class HistoryPanel final : public QFrame
{
    Q_OBJECT
public:
    explicit HistoryPanel(QWidget* parent);

    void setSource(HistorySource source) { m_source = std::move(source); }
    /// Sets the tooth of the current attempt.
    void setTooth(std::shared_ptr<const core::terrain::ToothAnatomy> tooth);
    void setColours(render::Palette colours);
    /// Reloads the history if its version has changed and the panel is visible. Otherwise does so when it is shown.
    void follow(std::uint64_t historyVersion);
    /// Places the panel at the left of `area`, no higher than needed.
    void placeIn(const QRect& area);

    [[nodiscard]] QListView& list() { return *m_list; }
    /// Returns the picture of a moment; null until it is drawn.
    [[nodiscard]] const QImage* picture(core::history::MomentId id);

    static constexpr int kPicturePx = 56;
    static constexpr int kMostPictures = 512;

signals:
    void momentRequested(const core::session::GoTo& where);
    void pictureDrawn();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void reload();
    void draw(core::history::MomentId id);
    void jumpTo(int row);

    HistorySource m_source;
    std::shared_ptr<const core::terrain::ToothAnatomy> m_tooth;
    render::Palette m_colours = render::Palette::Natural;
    std::uint64_t m_version = 0;
    bool m_isStale = true;
    QRect m_area;
    HistoryModel* m_model;
    QListView* m_list;
    QLabel* m_empty;
    QCache<std::uint64_t, QImage> m_pictures{kMostPictures};
    QSet<std::uint64_t> m_underWay;
    int m_drawing = 0;  ///< number of the current tooth and palette; pictures drawn for an older number are discarded
};

}  // namespace ui::practice
