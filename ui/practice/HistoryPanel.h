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

/// Where the panel asks for the history (core::session::SessionLoop). Ui thread.
struct HistorySource
{
    std::function<std::vector<core::history::MomentInfo>()> moments;
    /// The top map at a moment; empty if it is not known any more.
    std::function<std::vector<float>(core::history::MomentId)> heights;
};

/// The undo history over the tooth: each moment a small picture with when it was and what came off, branches beside
/// each other, the present one marked. A click or Enter goes there. Pictures are drawn by other threads when a row is
/// first seen, and the newest few hundred kept, some 6 KB each.
class HistoryPanel final : public QFrame
{
    Q_OBJECT
public:
    explicit HistoryPanel(QWidget* parent);

    void setSource(HistorySource source) { m_source = std::move(source); }
    /// The tooth on the table.
    void setTooth(std::shared_ptr<const core::terrain::ToothAnatomy> tooth);
    void setColours(render::Palette colours);
    /// What the session says; asks the source when that is another history than before, and the panel is seen.
    void follow(std::uint64_t historyVersion);
    /// At the left of `area`, no higher than needed.
    void placeIn(const QRect& area);

    [[nodiscard]] QListView& list() { return *m_list; }
    /// The picture of a moment; null until it is drawn.
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
    int m_drawing = 0;  ///< number of the tooth and palette drawn for: a picture of another comes too late
};

}  // namespace ui::practice
