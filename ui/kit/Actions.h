// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QAction>
#include <QList>
#include <QObject>
#include <QString>

class QLabel;
class QPushButton;
class QToolButton;
class QWidget;

namespace ui::kit {

/// The action table: everything the window can be asked to do, each with text, keys, tooltip, status tip and drawing.
/// Buttons, shortcuts and the help overlay are made from it, so none of them can disagree.
class Actions : public QObject
{
    Q_OBJECT
public:
    struct Group
    {
        const char* name;
        QList<QAction*> actions;

        [[nodiscard]] QString title() const { return tr(name); }
    };

    /// @param window  where the shortcuts are heard
    explicit Actions(QWidget* window);

    [[nodiscard]] const QList<Group>& groups() const { return m_groups; }
    /// What pauseReplay offers: to let the recording go on, or to hold it.
    void showReplayPaused(bool paused);
    /// @param username  empty: a guest
    void showAccount(const QString& username);
    /// What `devices` shows.
    /// @param drawing  its icon
    /// @param state    the hand in use and its state
    void showDevice(const QString& drawing, const QString& state);
    [[nodiscard]] bool isGuest() const { return m_username.isEmpty(); }
    /// Where `back` leads from the page that is shown.
    enum class Back { Tooth, Lessons, Attempts, Class };
    void showWayBack(Back to);
    /// An aid that the lesson does not allow says so in its tooltip, or why else it is not to be had. Whether it is
    /// enabled is the window's business.
    static void setAllowed(QAction* aid, bool allowed, const QString& whyNot = {});
    /// Returns whether setAllowed() has forbidden an action.
    [[nodiscard]] static bool isRefused(const QAction* aid);
    /// Indices of the burs that are at hand where a lesson names none. Stored between runs. An index without a bur and
    /// all after the fourth are ignored.
    void setFavouriteBurs(const QList<int>& favourites);
    [[nodiscard]] const QList<int>& favouriteBurs() const { return m_favouriteBurs; }
    static constexpr int kMostFavouriteBurs = 4;
    /// Indices of the burs that the panel shows and that the keys 1 to 4 choose: the first four that the lesson names,
    /// otherwise the favourites.
    [[nodiscard]] const QList<int>& bursAtHand() const
    {
        return m_lessonBurs.isEmpty() ? m_favouriteBurs : m_lessonBurs;
    }
    /// Calls setAllowed() for each bur.
    /// @param ids  ids of the allowed burs; empty: all are allowed
    void allowBurs(const std::vector<std::string>& ids);

    QAction* drill = nullptr;  ///< checkable: the bur turns
    QAction* otherHand = nullptr;
    QAction* bringHome = nullptr;  ///< hidden where the device cannot lead a hand
    QAction* resetView = nullptr;
    QAction* recentreHead = nullptr;  ///< hidden while the view does not follow the head
    QList<QAction*> handpieces;       ///< the same, of core::settings::handpieces(); visible where at hand
    QList<QAction*> burs;             ///< checkable, one of them; in the order of core::bur::burs()
    QAction* allBurs = nullptr;       ///< opens the picker of burs
    QAction* undo = nullptr;
    QAction* redo = nullptr;
    QAction* reload = nullptr;
    QAction* grade = nullptr;
    QAction* lessons = nullptr;
    QAction* editLesson = nullptr;  ///< on the page of lessons
    QAction* presets = nullptr;
    QAction* attempts = nullptr;   ///< hidden for a guest
    QAction* school = nullptr;     ///< hidden for who is no admin
    QAction* classes = nullptr;    ///< hidden for who has none
    QAction* readAgain = nullptr;  ///< on the page of classes
    QAction* search = nullptr;     ///< opens the lessons if the page has no search field
    QAction* chooseTooth = nullptr;
    QAction* mouth = nullptr;  ///< hidden where there is no OpenGL to draw it
    QAction* openScan = nullptr;
    QAction* saveRecording = nullptr;
    QAction* saveReference = nullptr;
    QAction* openRecording = nullptr;
    QAction* history = nullptr;  ///< checkable: the undo history is there
    // While a recording is played. Otherwise they are hidden, and their keys mean something else to the tooth.
    QAction* pauseReplay = nullptr;  ///< shares the space bar with `drill`: one of them rests at any time
    QAction* stepBack = nullptr;
    QAction* stepOn = nullptr;
    QAction* replayBegin = nullptr;
    QAction* replayEnd = nullptr;
    QAction* slower = nullptr;
    QAction* faster = nullptr;
    QAction* beside = nullptr;   ///< checkable: another attempt is shown beside
    QAction* along = nullptr;    ///< checkable: the device leads the hand; hidden where it cannot lead one
    QAction* expert = nullptr;   ///< also in practice; hidden in an exam, and where nothing is to be cut and no
                                 ///< recording lies with the lesson
    QAction* section = nullptr;  ///< checkable: the cross-section is there
    QAction* turnSection = nullptr;
    QAction* radiograph = nullptr;
    QAction* outline = nullptr;  ///< checkable: the ideal preparation is outlined on the tooth
    QAction* turnRound = nullptr;
    // Of the view (ViewMenu); all but the last two checkable.
    QAction* mirror = nullptr;
    QAction* burLight = nullptr;
    QAction* depthColours = nullptr;
    QAction* idealColours = nullptr;
    QAction* burColour = nullptr;
    QAction* fixture = nullptr;  ///< checkable: the outline holds the hand
    QAction* handPlace = nullptr;
    QAction* neighbours = nullptr;
    QAction* distinctColours = nullptr;
    QAction* wetLook = nullptr;
    QAction* stereo = nullptr;
    QAction* flipLeftRight = nullptr;
    QAction* flipUpDown = nullptr;
    QAction* reducedMotion = nullptr;
    QAction* stereoPage = nullptr;
    QAction* savePicture = nullptr;
    QAction* panel = nullptr;  ///< checkable: the side panel is there
    QAction* console = nullptr;
    QAction* settings = nullptr;
    QAction* devices = nullptr;  ///< its icon and tooltip show the hand in use
    QAction* account = nullptr;  ///< who is logged in; opens what he can do about it, or leads to the login
    QAction* lock = nullptr;
    QAction* sound = nullptr;  ///< checkable: the handpiece is heard
    QAction* fullScreen = nullptr;
    QAction* help = nullptr;
    QAction* tour = nullptr;
    QAction* back = nullptr;
    QAction* quit = nullptr;

signals:
    /// Emitted when the key of `expert` is pressed while that action is disabled.
    void expertMissing();
    void bursAtHandChanged();

private:
    void addDrillActions();
    void addHandpieceActions();
    void addToothActions();
    void addReplayActions();
    void addInsideActions();
    void addViewActions();
    void addWindowActions();
    /// @param text, tip  marked for translation; said again in every language
    QAction* add(const QString& drawing, const char* text, const char* tip, const QList<QKeySequence>& keys);
    QAction* add(const QString& drawing, std::function<QString()> text, const char* tip,
                 const QList<QKeySequence>& keys);
    void retranslateUi();
    void giveKeysToBurs();

    struct Words
    {
        QAction* action;
        std::function<QString()> text;
        const char* tip;
    };
    static void say(const Words& words);
    QWidget* m_window;
    QList<Group> m_groups;
    QList<int> m_favouriteBurs;
    QList<int> m_lessonBurs;
    QList<Words> m_words;
    [[nodiscard]] static QString tipOf(const QAction* action, const QString& what);
    [[nodiscard]] QString wayBack() const;
    QString m_username;
    Back m_back = Back::Tooth;
    bool m_isReplayPaused = false;
};

/// Says something now, and again whenever the words of the action are others.
void followWords(QAction* action, QWidget* listener, const std::function<void()>& say);

/// A flat icon button for a bar of the practice room. Reached with Tab; a click leaves the focus with the tooth.
[[nodiscard]] QToolButton* barButton(QAction* action, bool withText, QWidget* parent);

/// Says that nothing is kept, while nobody is logged in.
[[nodiscard]] QLabel* guestSign(const Actions& actions, QWidget* parent);

/// A button of a page that does what the action does, with its text and icon in the page's colours.
/// @param kind  "filled", "quiet" or "" (see cusp.qss)
[[nodiscard]] QPushButton* pageButton(QAction* action, const char* kind, QWidget* parent);

}  // namespace ui::kit
