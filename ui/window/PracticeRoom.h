// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QTimer>
#include <QWidget>

class QFrame;
class QHBoxLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace ui::kit {
class Actions;
class FoldingBar;
class TabularDigitsLabel;
}  // namespace ui::kit
namespace ui::practice {
class HistoryPanel;
class LessonStrip;
class SidePanel;
class ViewMenu;
}  // namespace ui::practice

namespace ui::inside {
class SectionView;
}

namespace ui::replay {
class ReplayBar;
}  // namespace ui::replay

namespace ui::tooth {
class ToothView;
}

namespace ui::window {

/// The page in which the student drills. The tooth fills it. The top bar names the tooth, the bottom bar contains the
/// buttons for the work, and the side panel shows numbers. The page is dark grey in both themes.
///
/// While the tooth view is pressed, the layout does not change, so that the tooth never moves under the bur. Widgets
/// that open, close or change their size meanwhile are placed after the release.
class PracticeRoom : public QWidget
{
    Q_OBJECT
public:
    /// @param view  shows the tooth; becomes a child
    PracticeRoom(kit::Actions& actions, practice::ViewMenu& viewMenu, tooth::ToothView* view, QWidget* parent);

    [[nodiscard]] practice::SidePanel& panel() { return *m_panel; }
    [[nodiscard]] inside::SectionView& section() { return *m_section; }
    /// Returns the strip above the tooth, which is hidden if there is no lesson.
    [[nodiscard]] practice::LessonStrip& lesson() { return *m_lesson; }
    /// Returns the bar that replaces the bottom bar while a recording is played.
    [[nodiscard]] replay::ReplayBar& replay() { return *m_replay; }
    /// Returns the panel of the undo history over the tooth, which is hidden until the user opens it.
    [[nodiscard]] practice::HistoryPanel& history() { return *m_history; }
    /// Adds the card of an exercise below the tooth. It takes room only while it is visible.
    void setExercise(QWidget* card);
    /// Adds the card of a trial beside the view. It takes room only while it is visible.
    void setTrial(QWidget* card);
    /// Shows another tooth to the right of the first one, each with its name above it. null: removes the other tooth
    /// and the names.
    void setBeside(QWidget* view, const QString& name = {});
    /// Shows the name of the tooth in the top bar.
    /// @param title  such as "Tooth 36", or the name of a file
    /// @param name   such as "lower left first molar", or empty
    void setTooth(const QString& title, const QString& name);
    /// Shows or hides the line at the lower edge of the view that says how to begin.
    void setHintVisible(bool visible);
    /// Sets whether the hand feels a force. If so, the hint is hidden, because it is about the mouse.
    void setHandHasForce(bool hasForce)
    {
        m_handHasForce = hasForce;
        setHintVisible(m_hintWanted);
    }
    /// Shows a notice about harm over the tooth for eight seconds.
    /// @param whatToDo  a second sentence; may be empty
    void showNotice(const QString& what, const QString& whatToDo);
    /// Hides the notice. Returns whether one was shown.
    bool hideNotice();
    /// Shows a comment on the moment that is played, at the lower edge of the view. Empty: hides it.
    void showRemark(const QString& words);
    void setReplaying(bool replaying);
    /// Shows or hides the side panel.
    void setPanelVisible(bool visible);
    /// Shows or hides the cross-section beside the tooth.
    void setSectionVisible(bool visible);
    /// Returns the area of the tooth view, in this widget's coordinates.
    [[nodiscard]] QRect viewArea() const;
    /// Returns the position that overlays must not cover, in this widget's coordinates. This is the position of the bur
    /// while the view is pressed or a recording is played, and its last such position afterwards, so that a card does
    /// not move away from the pointer.
    [[nodiscard]] const std::optional<QPointF>& burPlace() const { return m_bur; }

signals:
    /// Emitted when viewArea() or burPlace() has changed.
    void viewAreaChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void keepLayout(bool kept);
    void fitSection();
    QWidget* makeTopBar(const kit::Actions& actions);
    QWidget* makeBottomBar(const kit::Actions& actions, practice::ViewMenu& viewMenu);
    static QLabel* accountName(const kit::Actions& actions, QWidget* parent);
    void makeNotice();
    void placeOverlays();
    void placeNotice();
    void placeAtFoot(QLabel& words, const QRect& area) const;
    void followBur();

    tooth::ToothView* m_view;
    practice::SidePanel* m_panel;
    inside::SectionView* m_section;
    bool m_isSectionWanted = false;
    QWidget* m_trial = nullptr;
    practice::LessonStrip* m_lesson;
    QToolButton* m_tooth = nullptr;
    QLabel* m_name = nullptr;
    kit::FoldingBar* m_topBar = nullptr;
    QToolButton* m_saveReference = nullptr;
    QHBoxLayout* m_middle = nullptr;
    QVBoxLayout* m_viewColumn = nullptr;
    QWidget* m_beside = nullptr;
    QLabel* m_besideName = nullptr;  ///< above the other tooth
    QLabel* m_ourName = nullptr;     ///< above the first tooth, while another is shown beside it
    QWidget* m_workBar = nullptr;
    replay::ReplayBar* m_replay = nullptr;
    practice::HistoryPanel* m_history = nullptr;
    QLabel* m_hint = nullptr;
    QLabel* m_remark = nullptr;  ///< shown only while a recording is played
    QFrame* m_notice = nullptr;
    QLabel* m_noticeWhat = nullptr;
    QLabel* m_noticeToDo = nullptr;
    QTimer m_noticeTimer;
    bool m_hintWanted = true;
    bool m_handHasForce = false;
    std::optional<QPointF> m_bur;
    bool m_areaIsNew = false;  ///< the view was resized after m_bur was set
};

}  // namespace ui::window
