// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/Actions.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <QActionGroup>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>

#include "core/bur/Bur.h"
#include "core/settings/Handpiece.h"
#include "ui/kit/AppSettings.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::kit {
namespace {

constexpr const char* kDrawing = "drawing";
constexpr const char* kOwnTip = "ownTip";
const QString kFavouriteBurs = QStringLiteral("burs/favourites");

QString drawingOf(const QAction* action)
{
    return action->property(kDrawing).toString();
}

/// Returns the favourite burs of the last run, otherwise the first burs.
QList<int> rememberedBurs()
{
    QList<int> favourites;
    const QSettings kept = memory();
    for (const QString& id : kept.value(kFavouriteBurs).toStringList())
        if (const auto bur = core::bur::findBur(id.toStdString()))
            favourites << static_cast<int>(*bur);
    if (!kept.contains(kFavouriteBurs))
        for (std::size_t k = 0; k < core::bur::kCommonBurs; ++k)
            favourites << static_cast<int>(k);
    return favourites;
}

}  // namespace

Actions::Actions(QWidget* window) : QObject(window), m_window(window)
{
    addDrillActions();
    addHandpieceActions();
    addToothActions();
    addReplayActions();
    addInsideActions();
    addViewActions();
    addWindowActions();
    text::bindTranslation(window, [this] { retranslateUi(); });
}

void Actions::addDrillActions()
{
    m_groups.push_back({QT_TR_NOOP("Drill"), {}});
    drill =
        add("drill", QT_TR_NOOP("Drill on or off"), QT_TR_NOOP("Start or stop the bur"), {Qt::Key_D, Qt::Key_Space});
    drill->setCheckable(true);
    undo = add("undo", QT_TR_NOOP("Undo"), QT_TR_NOOP("Undo the last stroke"), {Qt::CTRL | Qt::Key_Z});
    redo = add("redo", QT_TR_NOOP("Redo"), QT_TR_NOOP("Redo the stroke that was undone"),
               {Qt::CTRL | Qt::SHIFT | Qt::Key_Z});
    history = add("history", QT_TR_NOOP("History"), QT_TR_NOOP("Show or hide the undo history with all its branches"),
                  {Qt::Key_U});
    history->setCheckable(true);
    reload =
        add("reload", QT_TR_NOOP("Start again"), QT_TR_NOOP("Reset the tooth; Undo restores your work"), {Qt::Key_R});
    grade =
        add("grade", QT_TR_NOOP("Grade"), QT_TR_NOOP("Measure your preparation and explain the grade"), {Qt::Key_G});
}

void Actions::addHandpieceActions()
{
    m_groups.push_back({QT_TR_NOOP("Handpiece"), {}});
    auto* oneBur = new QActionGroup(this);
    for (const core::bur::Bur& bur : core::bur::burs()) {
        QAction* action = add({}, [&bur] { return text::burName(bur.id); }, QT_TR_NOOP("Use this bur"), {});
        action->setCheckable(true);
        oneBur->addAction(action);
        burs.push_back(action);
    }
    allBurs =
        add("burs", QT_TR_NOOP("All burs"), QT_TR_NOOP("Choose from all burs, and which are at hand"), {Qt::Key_0});
    setFavouriteBurs(rememberedBurs());
    auto* oneHandpiece = new QActionGroup(this);
    int digit = Qt::Key_7;
    for (const core::settings::Handpiece& handpiece : core::settings::handpieces()) {
        QAction* action = add("handpiece", [&handpiece] { return text::handpieceName(handpiece.name); },
                              QT_TR_NOOP("Use this handpiece"), {QKeySequence(digit++)});
        action->setCheckable(true);
        oneHandpiece->addAction(action);
        handpieces.push_back(action);
    }
    otherHand = add("hand", QT_TR_NOOP("Other hand"),
                    QT_TR_NOOP("Hold the handpiece from the other side; the view stays"), {Qt::Key_H});
    otherHand->setCheckable(true);
    bringHome = add("home", QT_TR_NOOP("Return the handpiece"),
                    QT_TR_NOOP("Let the handpiece guide your hand back over the tooth"), {Qt::Key_C});
}

void Actions::addToothActions()
{
    m_groups.push_back({QT_TR_NOOP("Tooth and files"), {}});
    lessons = add("lessons", QT_TR_NOOP("Lessons"), QT_TR_NOOP("Choose what to practise"), {Qt::Key_F2});
    editLesson = add("edit", QT_TR_NOOP("Edit the lesson …"),
                     QT_TR_NOOP("Change the ideal and the rubric of the selected lesson"), {Qt::Key_F4});
    attempts = add("attempts", QT_TR_NOOP("My attempts"), QT_TR_NOOP("See the results of your attempts"), {Qt::Key_F3});
    classes =
        add("class", QT_TR_NOOP("Classes"), QT_TR_NOOP("See the results of a class and who needs help"), {Qt::Key_F6});
    readAgain = add("reload", QT_TR_NOOP("Reload"), QT_TR_NOOP("Show changes made on other computers"), {Qt::Key_F5});
    school =
        add("settings", QT_TR_NOOP("School"), QT_TR_NOOP("People, class lists, backups and the audit"), {Qt::Key_F8});
    for (QAction* one : {attempts, classes, readAgain, school})
        one->setVisible(false);
    presets = add("dials", QT_TR_NOOP("Hardness presets"), QT_TR_NOOP("Choose, try and change how drilling feels"),
                  {Qt::Key_F7});
    chooseTooth = add("tooth", QT_TR_NOOP("Choose a tooth"), QT_TR_NOOP("Show the arches and choose one of 16 teeth"),
                      {Qt::Key_T});
    mouth = add("mouth", QT_TR_NOOP("Whole mouth"),
                QT_TR_NOOP("Choose a tooth in the whole mouth, or go back to the flat arches"), {Qt::Key_M});
    openScan = add("open", QT_TR_NOOP("Open a scan"), QT_TR_NOOP("Open the scan of a tooth: OBJ, STL or PLY"),
                   {Qt::CTRL | Qt::Key_O});
    saveRecording = add("save", QT_TR_NOOP("Save the recording"),
                        QT_TR_NOOP("Save every movement of this attempt to a file"), {Qt::CTRL | Qt::Key_S});
    saveReference =
        add("reference", QT_TR_NOOP("Save this attempt as a reference …"),
            QT_TR_NOOP("Save your preparation as an ideal for lessons"), {Qt::CTRL | Qt::SHIFT | Qt::Key_S});
    openRecording = add("play", QT_TR_NOOP("Open a recording"), QT_TR_NOOP("Replay a saved attempt"),
                        {Qt::CTRL | Qt::SHIFT | Qt::Key_O});
    expert = add("expert", QT_TR_NOOP("The expert's attempt"),
                 QT_TR_NOOP("Watch how an expert does it; during a replay, beside this attempt"), {Qt::Key_Y});
    auto* missing = new QShortcut(expert->shortcut(), m_window);
    missing->setEnabled(false);
    connect(expert, &QAction::enabledChanged, missing, [missing](bool enabled) { missing->setEnabled(!enabled); });
    connect(missing, &QShortcut::activated, this, &Actions::expertMissing);
}

void Actions::addReplayActions()
{
    m_groups.push_back({QT_TR_NOOP("Replay"), {}});
    pauseReplay = add("pause", [this] { return m_isReplayPaused ? tr("Resume the replay") : tr("Pause the replay"); },
                      QT_TR_NOOP("Pause or resume the replay"), {Qt::Key_Space});
    stepBack = add("step-back", QT_TR_NOOP("Previous stroke"),
                   QT_TR_NOOP("Go to the end of the previous stroke and pause"), {Qt::Key_Left, Qt::Key_Comma});
    stepOn = add("step-on", QT_TR_NOOP("Next stroke"), QT_TR_NOOP("Go to the end of the next stroke and pause"),
                 {Qt::Key_Right, Qt::Key_Period});
    replayBegin = add("to-begin", QT_TR_NOOP("To the beginning"), QT_TR_NOOP("Go to the beginning of the recording"),
                      {Qt::Key_Home});
    replayEnd = add("to-end", QT_TR_NOOP("To the end"), QT_TR_NOOP("Go to the end of the recording"), {Qt::Key_End});
    slower = add("slower", QT_TR_NOOP("Slower"), QT_TR_NOOP("Play the recording more slowly, down to a tenth"),
                 {Qt::Key_BracketLeft, Qt::Key_Down});
    faster = add("faster", QT_TR_NOOP("Faster"), QT_TR_NOOP("Play the recording faster, up to 16 times"),
                 {Qt::Key_BracketRight, Qt::Key_Up});
    beside = add("beside", QT_TR_NOOP("Compare with …"),
                 QT_TR_NOOP("Open another attempt beside this one, or close it"), {Qt::CTRL | Qt::Key_B});
    beside->setCheckable(true);
    along =
        add("along", QT_TR_NOOP("Guide my hand"),
            QT_TR_NOOP("Let the handpiece guide your hand along the attempt; push against it to stop"), {Qt::Key_A});
    along->setCheckable(true);
}

void Actions::addInsideActions()
{
    m_groups.push_back({QT_TR_NOOP("Seeing inside"), {}});
    section =
        add("section", QT_TR_NOOP("Section"), QT_TR_NOOP("Show or hide a live section through the bur"), {Qt::Key_X});
    section->setCheckable(true);
    turnSection = add("view", QT_TR_NOOP("Turn the section"),
                      QT_TR_NOOP("Turn the section around the bur by 15 degrees"), {Qt::SHIFT | Qt::Key_X});
    radiograph = add("film", QT_TR_NOOP("X-ray"),
                     QT_TR_NOOP("Show X-ray pictures of the tooth, before and now, or close them"), {Qt::Key_F});

    //: Of the ideal preparation, drawn on the tooth
    outline = add("outline", QT_TR_NOOP("Outline"),
                  QT_TR_NOOP("Show or hide the outline of the ideal preparation on the tooth"), {Qt::Key_O});
    outline->setCheckable(true);
}

void Actions::addViewActions()
{
    m_groups.push_back({QT_TR_NOOP("View"), {}});
    resetView = add("view", QT_TR_NOOP("Reset view"), QT_TR_NOOP("Return to the initial view"), {Qt::Key_V});
    turnRound = add("turn", QT_TR_NOOP("Rotate 180°"), QT_TR_NOOP("Look at the tooth from the opposite side"),
                    {Qt::SHIFT | Qt::Key_H});
    recentreHead = add("view", QT_TR_NOOP("Straight ahead is here"),
                       QT_TR_NOOP("Make the present position of your head the middle one"), {Qt::SHIFT | Qt::Key_V});
    recentreHead->setVisible(false);
    const auto choice = [this](const QString& drawing, const char* text, const char* tip,
                               const QList<QKeySequence>& keys) {
        QAction* action = add(drawing, text, tip, keys);
        action->setCheckable(true);
        return action;
    };
    //: The small round mirror on a handle
    mirror =
        choice("mirror", QT_TR_NOOP("Dental mirror"),
               QT_TR_NOOP("Show or hide the mirror; drag its glass to move it, with Shift to tilt it"), {Qt::Key_E});
    burLight = choice("light", QT_TR_NOOP("Light on the handpiece"), QT_TR_NOOP("Light the cavity from the handpiece"),
                      {Qt::Key_L});
    depthColours = choice("depth", QT_TR_NOOP("Depth colours"),
                          QT_TR_NOOP("Colour the cut by its depth and show the depth at the pointer"), {Qt::Key_K});
    idealColours =
        choice("ideal", QT_TR_NOOP("Deviation from the ideal"),
               QT_TR_NOOP("Colour what is too deep and what is still to cut, and show the value at the pointer"),
               {Qt::SHIFT | Qt::Key_K});
    //: The bur tells by its colour how near it is to what is to be kept
    burColour = choice("target", QT_TR_NOOP("Colour the bur"),
                       QT_TR_NOOP("Colour the bur by its distance from tissue that must be kept"), {Qt::Key_A});
    fixture = choice("rail", QT_TR_NOOP("Guided hand"), QT_TR_NOOP("A gentle force keeps the hand within the outline"),
                     {Qt::Key_Q});
    neighbours = choice("mouth", QT_TR_NOOP("Neighbouring teeth"), QT_TR_NOOP("Show the adjacent teeth and the gum"),
                        {Qt::Key_N});
    handPlace = choice("ghost", QT_TR_NOOP("Hand position"), QT_TR_NOOP("Show faintly where the hand holds the bur"),
                       {Qt::Key_B});
    distinctColours =
        choice("palette", QT_TR_NOOP("Colour-blind palette"),
               QT_TR_NOOP("Give each tissue a colour and a pattern that are easy to tell apart"), {Qt::Key_P});
    //: The tooth as if it were wet
    wetLook =
        choice("drop", QT_TR_NOOP("Wet tooth"), QT_TR_NOOP("Make the tooth shine as if it were wet"), {Qt::Key_W});
    stereo = choice("glasses", QT_TR_NOOP("Stereo picture"), QT_TR_NOOP("One picture for each eye"), {Qt::Key_S});
    stereoPage = add("glasses", QT_TR_NOOP("Set up the stereo picture …"),
                     QT_TR_NOOP("Choose glasses or screen and fit it to your eyes"), {Qt::SHIFT | Qt::Key_S});
    flipLeftRight = choice("flip-h", QT_TR_NOOP("Mirror horizontally"),
                           QT_TR_NOOP("For a half-silvered mirror over the hand"), {Qt::ALT | Qt::Key_H});
    flipUpDown = choice("flip-v", QT_TR_NOOP("Mirror vertically"),
                        QT_TR_NOOP("For a screen mounted upside down over the hand"), {Qt::ALT | Qt::Key_V});
    savePicture = add("picture", QT_TR_NOOP("Save a picture …"), QT_TR_NOOP("Save what the view shows as a PNG"),
                      {Qt::CTRL | Qt::Key_P});
    reducedMotion = choice("calm", QT_TR_NOOP("Less motion"), QT_TR_NOOP("No animations and no spinning bur"),
                           {Qt::ALT | Qt::Key_M});
}

void Actions::addWindowActions()
{
    m_groups.push_back({QT_TR_NOOP("Window"), {}});
    panel = add("panel", QT_TR_NOOP("Side panel"), QT_TR_NOOP("Show or hide the figures"), {Qt::Key_F9});
    panel->setCheckable(true);
    panel->setChecked(true);
    console =
        add("console", QT_TR_NOOP("Console"), QT_TR_NOOP("Show or hide parameters that you can change while you drill"),
            {Qt::Key_F10, Qt::Key_QuoteLeft});
    settings =
        add("settings", QT_TR_NOOP("Settings"), QT_TR_NOOP("Every setting with its range"), {Qt::CTRL | Qt::Key_Comma});
    devices =
        add("mouse", QT_TR_NOOP("Devices"), QT_TR_NOOP("Choose and try what moves the bur"), {Qt::CTRL | Qt::Key_D});
    sound = add("sound", QT_TR_NOOP("Sound"), QT_TR_NOOP("Sound of the handpiece on or off"), {Qt::CTRL | Qt::Key_M});
    sound->setCheckable(true);
    account = add("account", [this] { return m_username.isEmpty() ? tr("Log in") : m_username; },
                  QT_TR_NOOP("Log in, lock this workstation, or change your password or the language"), {});
    lock = add("account", [this] { return m_username.isEmpty() ? tr("Log in") : tr("Lock or switch user"); },
               QT_TR_NOOP("Your work stays open; a password is needed to continue"), {Qt::CTRL | Qt::Key_L});
    search = add("search", QT_TR_NOOP("Search"), QT_TR_NOOP("Search on this page, or among the lessons"),
                 {Qt::CTRL | Qt::Key_F});
    fullScreen = add("fullscreen", QT_TR_NOOP("Full screen"), QT_TR_NOOP("Fill the whole screen"), {Qt::Key_F11});
    fullScreen->setCheckable(true);
    help = add("help", QT_TR_NOOP("Keys and mouse"), QT_TR_NOOP("Show what every key does"), {Qt::Key_F1});
    tour = add("expert", QT_TR_NOOP("Take the tour"), QT_TR_NOOP("Get to know the window step by step"),
               {Qt::SHIFT | Qt::Key_F1});
    back = add("back", [this] { return wayBack(); }, QT_TR_NOOP("Close this page; nothing is lost"), {Qt::Key_Escape});
    quit = add("close", QT_TR_NOOP("Quit"), QT_TR_NOOP("Close Cusp"), {Qt::CTRL | Qt::Key_Q});
}

void Actions::showReplayPaused(bool paused)
{
    m_isReplayPaused = paused;
    pauseReplay->setText(paused ? tr("Resume the replay") : tr("Pause the replay"));
    pauseReplay->setIcon(lineIcon(paused ? QStringLiteral("play") : QStringLiteral("pause"), roomPalette()));
}

QString Actions::wayBack() const
{
    switch (m_back) {
    case Back::Attempts:
        return tr("Back to the attempts");
    case Back::Class:
        return tr("Back to the class");
    case Back::Lessons:
        return tr("Back to the lessons");
    case Back::Tooth:
        break;
    }
    return tr("Back to the tooth");
}

void Actions::showWayBack(Back to)
{
    m_back = to;
    back->setText(wayBack());
}

void Actions::showAccount(const QString& username)
{
    m_username = username;
    account->setText(username.isEmpty() ? tr("Log in") : username);
    lock->setText(username.isEmpty() ? tr("Log in") : tr("Lock or switch user"));
}

void Actions::showDevice(const QString& drawing, const QString& state)
{
    if (devices->property(kDrawing).toString() != drawing) {
        devices->setProperty(kDrawing, drawing);
        devices->setIcon(lineIcon(drawing, roomPalette()));
    }
    const QString tip = tipOf(devices, devices->statusTip());
    devices->setToolTip(state.isEmpty() ? tip : state + u'\n' + tip);
}

void Actions::setAllowed(QAction* aid, bool allowed, const QString& whyNot)
{
    if (!aid->property(kOwnTip).isValid())
        aid->setProperty(kOwnTip, aid->toolTip());
    aid->setToolTip(allowed            ? aid->property(kOwnTip).toString()
                    : whyNot.isEmpty() ? tr("This lesson does not allow it.")
                                       : whyNot);
}

bool Actions::isRefused(const QAction* aid)
{
    const QVariant own = aid->property(kOwnTip);
    return own.isValid() && own.toString() != aid->toolTip();
}

void Actions::setFavouriteBurs(const QList<int>& favourites)
{
    m_favouriteBurs.clear();
    for (const int bur : favourites)
        if (bur >= 0 && bur < burs.size() && !m_favouriteBurs.contains(bur) &&
            m_favouriteBurs.size() < kMostFavouriteBurs)
            m_favouriteBurs << bur;
    QStringList ids;
    for (const int bur : std::as_const(m_favouriteBurs))
        ids << QString::fromStdString(core::bur::burs()[static_cast<std::size_t>(bur)].id);
    if (QSettings kept = memory(); kept.value(kFavouriteBurs).toStringList() != ids)
        kept.setValue(kFavouriteBurs, ids);
    giveKeysToBurs();
}

void Actions::giveKeysToBurs()
{
    for (QAction* action : std::as_const(burs))
        action->setShortcuts(QList<QKeySequence>{});
    for (qsizetype k = 0; k < bursAtHand().size(); ++k)
        burs[bursAtHand()[k]]->setShortcut(QKeySequence(Qt::Key_1 + static_cast<int>(k)));
    for (const Words& words : std::as_const(m_words))
        if (burs.contains(words.action))
            say(words);  // tooltips contain the shortcuts
    emit bursAtHandChanged();
}

void Actions::allowBurs(const std::vector<std::string>& ids)
{
    for (qsizetype k = 0; k < burs.size(); ++k) {
        const std::string_view id = core::bur::burs()[static_cast<std::size_t>(k)].id;
        setAllowed(burs[k], ids.empty() || std::find(ids.begin(), ids.end(), id) != ids.end());
    }
    m_lessonBurs.clear();
    for (const std::string& id : ids)
        if (const auto bur = core::bur::findBur(id); bur && m_lessonBurs.size() < kMostFavouriteBurs)
            m_lessonBurs << static_cast<int>(*bur);
    giveKeysToBurs();
}

QAction* Actions::add(const QString& drawing, std::function<QString()> text, const char* tip,
                      const QList<QKeySequence>& keys)
{
    auto* action = new QAction(this);
    action->setShortcuts(keys);
    action->setProperty(kDrawing, drawing);
    action->setIcon(lineIcon(drawing, roomPalette()));
    m_window->addAction(action);
    m_groups.back().actions.push_back(action);
    m_words.push_back({action, std::move(text), tip});
    return action;
}

QAction* Actions::add(const QString& drawing, const char* text, const char* tip, const QList<QKeySequence>& keys)
{
    return add(
        drawing, [text] { return tr(text); }, tip, keys);
}

QString Actions::tipOf(const QAction* action, const QString& what)
{
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    //: Tooltip: what it does, then its key
    return key.isEmpty() ? what : tr("%1 (%2)").arg(what, key);
}

void Actions::retranslateUi()
{
    for (const Words& words : std::as_const(m_words))
        say(words);
}

void Actions::say(const Words& words)
{
    const QString tip = tr(words.tip);
    const QString whole = tipOf(words.action, tip);
    const bool refused = isRefused(words.action);
    if (words.action->property(kOwnTip).isValid())
        words.action->setProperty(kOwnTip, whole);
    words.action->setText(words.text());
    words.action->setStatusTip(tip);
    if (!refused)  // otherwise the window sets the reason again
        words.action->setToolTip(whole);
}

void followWords(QAction* action, QWidget* listener, const std::function<void()>& say)
{
    say();
    QObject::connect(action, &QAction::changed, listener,
                     [action, say, text = action->text(), tip = action->toolTip()]() mutable {
                         if (action->text() == text && action->toolTip() == tip)
                             return;
                         text = action->text();
                         tip = action->toolTip();
                         say();
                     });
}

QToolButton* barButton(QAction* action, bool withText, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setToolButtonStyle(withText ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    button->setIconSize({20, 20});
    button->setFocusPolicy(Qt::TabFocus);
    button->setAutoRaise(true);
    followWords(action, button, [button, action] {
        button->setAccessibleName(action->text());
        button->setAccessibleDescription(action->toolTip());
    });
    if (!action->isVisible())
        button->hide();
    QObject::connect(action, &QAction::visibleChanged, button,
                     [button, action] { button->setVisible(action->isVisible()); });
    return button;
}

QPushButton* pageButton(QAction* action, const char* kind, QWidget* parent)
{
    auto* button = new QPushButton(parent);
    button->setProperty("kind", kind);
    QPalette colours = parent->palette();
    if (qstrcmp(kind, "filled") == 0)
        colours.setColor(QPalette::Active, QPalette::ButtonText, colours.color(QPalette::HighlightedText));
    button->setIcon(lineIcon(drawingOf(action), colours));
    button->setIconSize({18, 18});
    followWords(action, button, [button, action] {
        button->setText(action->text());
        button->setToolTip(action->toolTip());
        button->setStatusTip(action->statusTip());
        button->setAccessibleName(action->text());
        button->setAccessibleDescription(action->toolTip());
    });
    button->setFocusPolicy(Qt::TabFocus);
    button->setAutoDefault(true);  // Enter presses the button, too
    button->setEnabled(action->isEnabled());
    QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
    QObject::connect(action, &QAction::enabledChanged, button, &QPushButton::setEnabled);
    return button;
}

QLabel* guestSign(const Actions& actions, QWidget* parent)
{
    auto* sign = new QLabel(parent);
    sign->setForegroundRole(QPalette::PlaceholderText);
    sign->setFont(typeface(kSmall));
    sign->setObjectName(QStringLiteral("guestSign"));
    followWords(actions.account, sign, [sign, &actions] {
        //: Beside "Log in", on every page: what is done now is kept for nobody. Two short lines.
        sign->setText(Actions::tr("Guest,\nunsaved"));
        sign->setVisible(actions.isGuest());
    });
    return sign;
}

}  // namespace ui::kit
