// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/LoginPage.h"

#include <utility>

#include <QCheckBox>
#include <QFormLayout>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "database/Usernames.h"
#include "ui/kit/Accessibility.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/LanguageMenu.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/people/WelcomeChoices.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Language.h"

namespace ui::people {
namespace {

using namespace ui::kit;

constexpr int kCardPx = 400;
constexpr int kLongestInput = 300;
constexpr int kLongestName = 200;
constexpr int kSoonMs = 600;  ///< longer operations show a message; checking a password takes half of this time

}  // namespace

LoginPage::LoginPage(QWidget* parent)
    : QWidget(parent), m_card(new QFrame(this)), m_column(new QVBoxLayout(m_card)), m_title(new QLabel(m_card)),
      m_words(kit::formWords({}, kBody, QFont::Normal, QPalette::PlaceholderText, m_card)),
      m_choices(new WelcomeChoices(m_card)), m_name(field("username", false)), m_given(field("givenName", false)),
      m_family(field("familyName", false)), m_old(field("oldPassword", true)), m_password(field("password", true)),
      m_again(field("passwordAgain", true)), m_keep(new QCheckBox(m_card)), m_fault(kit::faultLabel(m_card)),
      m_waiting(kit::formWords({}, kBody, QFont::Normal, QPalette::PlaceholderText, m_card)),
      m_untilTold(new QTimer(this)), m_go(new QPushButton(m_card)), m_other(new QPushButton(m_card)),
      m_guest(new QPushButton(m_card)), m_change(new QPushButton(m_card)),
      m_said(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, m_card)),
      m_unreachable(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, m_card)),
      m_tryAgain(new QPushButton(m_card)), m_restore(new QPushButton(m_card)), m_language(new QToolButton(m_card))
{
    setAutoFillBackground(true);
    m_card->setProperty("kind", "card");
    m_card->setFixedWidth(kCardPx);
    m_title->setFont(typeface(kFigure, QFont::DemiBold));
    m_title->setTextFormat(Qt::PlainText);
    m_title->setWordWrap(true);
    fillCard();

    auto* content = new QWidget(this);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(m_card);
    row->addStretch(1);
    auto* column = new QVBoxLayout(content);
    column->addStretch(2);
    column->addLayout(row);
    column->addStretch(3);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    // Scrolls if the window is low or a translation is long.
    whole->addWidget(new ScrollPane(content, QPalette::Window, this));

    connectInputs();
    text::bindTranslation(this, [this] {
        retranslateUi();
        say(m_saying);
        showFault(m_faultWords);
    });
    ask(LoginMode::Login);
}

void LoginPage::fillCard()
{
    m_column->setContentsMargins(kSpace6 + kSpace2, kSpace6, kSpace6 + kSpace2, kSpace6);
    m_column->setSpacing(kSpace2);
    m_column->addWidget(m_title);
    m_column->addWidget(m_words);
    m_column->addSpacing(kSpace2);
    m_column->addWidget(m_choices);
    connect(m_choices, &WelcomeChoices::practiceRequested, this, &LoginPage::guestRequested);
    connect(m_choices, &WelcomeChoices::schoolRequested, this, [this] { ask(LoginMode::NewSchool); });
    for (QLineEdit* input : {m_name, m_given, m_family, m_old, m_password, m_again}) {
        auto* caption = new QLabel(m_card);
        caption->setFont(typeface(kSmall));
        caption->setForegroundRole(QPalette::PlaceholderText);
        caption->setBuddy(input);
        m_captions[input] = caption;
        m_column->addWidget(caption);
        m_column->addWidget(input);
    }
    m_keep->setObjectName(QStringLiteral("keepOnLogin"));
    m_column->addWidget(m_keep);
    m_column->addWidget(m_fault);
    m_waiting->setObjectName(QStringLiteral("waiting"));
    m_waiting->hide();
    m_untilTold->setSingleShot(true);
    m_untilTold->setInterval(kSoonMs);
    connect(m_untilTold, &QTimer::timeout, this, [this] {
        m_waiting->show();
        announce(*m_waiting);
    });
    m_column->addWidget(m_waiting);
    m_column->addSpacing(kSpace2);
    addButtons();
    m_language->setObjectName(QStringLiteral("language"));
    m_language->setMenu(new LanguageMenu(m_language));
    m_language->setPopupMode(QToolButton::InstantPopup);
    m_language->setAutoRaise(true);
    m_language->setFocusPolicy(Qt::StrongFocus);
    m_column->addWidget(m_language, 0, Qt::AlignHCenter);
}

void LoginPage::connectInputs()
{
    QWidget* before = m_name;
    for (QWidget* next :
         std::initializer_list<QWidget*>{m_given, m_family, m_old, m_password, m_again, m_keep, m_go, m_other, m_guest,
                                         m_change, m_restore, m_tryAgain, m_language}) {
        setTabOrder(before, next);
        before = next;
    }
    connect(m_go, &QPushButton::clicked, this, &LoginPage::submit);
    for (QLineEdit* input : {m_name, m_given, m_family, m_old, m_password, m_again})
        connect(input, &QLineEdit::returnPressed, this, [this, input] {
            // Return moves to the next empty field. In the last field it submits the form.
            for (QLineEdit* next : {m_name, m_given, m_family, m_old, m_password, m_again})
                if (next != input && next->isVisible() && next->text().isEmpty()) {
                    next->setFocus();
                    return;
                }
            submit();
        });
    connect(m_other, &QPushButton::clicked, this, [this] {
        if (m_door == LoginMode::NewSchool)
            ask(LoginMode::Welcome);
        else if (m_door == LoginMode::Locked)
            emit otherRequested();
        else if (m_isIn)
            emit leaveRequested();
        else
            ask(m_door == LoginMode::OwnPassword ? LoginMode::Locked : LoginMode::Login);
    });
    connect(m_change, &QPushButton::clicked, this, [this] { ask(LoginMode::OwnPassword); });
    connect(m_guest, &QPushButton::clicked, this, &LoginPage::guestRequested);
    const auto offer = [this](QPushButton* button, void (LoginPage::*wanted)()) {
        connect(button, &QPushButton::clicked, this, [this, wanted] {
            setBusy(true);
            emit(this->*wanted)();
        });
    };
    offer(m_tryAgain, &LoginPage::againRequested);
    offer(m_restore, &LoginPage::restoreRequested);
}

void LoginPage::addButtons()
{
    m_go->setProperty("kind", "filled");
    m_go->setObjectName(QStringLiteral("logIn"));
    m_go->setAutoDefault(true);
    m_other->setProperty("kind", "quiet");
    m_other->setObjectName(QStringLiteral("otherLogin"));
    m_guest->setProperty("kind", "quiet");
    m_guest->setObjectName(QStringLiteral("practiseAsGuest"));
    m_change->setProperty("kind", "quiet");
    m_change->setObjectName(QStringLiteral("changePassword"));
    for (QPushButton* button : {m_go, m_other, m_guest, m_change})
        m_column->addWidget(button);
    m_column->addSpacing(kSpace2);
    m_column->addWidget(m_said);
    m_column->addWidget(m_unreachable);
    m_tryAgain->setObjectName(QStringLiteral("tryAgain"));
    m_restore->setObjectName(QStringLiteral("restoreBackup"));
    for (QPushButton* button : {m_restore, m_tryAgain}) {
        button->setAutoDefault(true);
        m_column->addWidget(button);
    }
    m_restore->hide();
    setUnreachable({});
}

QLineEdit* LoginPage::field(const char* name, bool isPassword)
{
    auto* input = new QLineEdit(m_card);
    input->setObjectName(QLatin1String(name));
    input->setFont(typeface(kBody));
    input->setMaxLength(isPassword ? kLongestInput : kLongestName);
    if (isPassword) {
        input->setEchoMode(QLineEdit::Password);
        input->setInputMethodHints(Qt::ImhHiddenText | Qt::ImhSensitiveData | Qt::ImhNoPredictiveText);
    }
    return input;
}

void LoginPage::ask(LoginMode door, bool isIn)
{
    if (door == LoginMode::NewPassword && m_door == LoginMode::Locked)
        m_name->setText(m_lockedBy);  // the one-time code is for this user
    m_door = door;
    m_isIn = isIn;
    if (door == LoginMode::NewPassword)
        m_code = m_password->text();
    else
        m_code.clear();
    if (door != LoginMode::NewPassword)
        m_name->clear();
    for (QLineEdit* input : {m_given, m_family, m_old, m_password, m_again})
        input->clear();
    showFault({});
    say({});
    setBusy(false);
    arrange();
    retranslateUi();
    if (isVisible())
        firstInput()->setFocus();
}

QWidget* LoginPage::firstInput() const
{
    if (m_door == LoginMode::Welcome)
        return m_choices;
    return m_door == LoginMode::Login || m_door == LoginMode::NewSchool ? m_name
           : m_door == LoginMode::OwnPassword                           ? m_old
                                                                        : m_password;
}

void LoginPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    firstInput()->setFocus();
}

void LoginPage::arrange()
{
    const bool isNew = m_door == LoginMode::NewSchool;
    const bool isWelcome = m_door == LoginMode::Welcome;
    m_choices->setVisible(isWelcome);
    m_password->setVisible(!isWelcome);
    m_go->setVisible(!isWelcome);
    m_name->setVisible(m_door == LoginMode::Login || isNew);
    m_given->setVisible(isNew);
    m_family->setVisible(isNew);
    m_old->setVisible(m_door == LoginMode::OwnPassword);
    m_again->setVisible(isNew || m_door == LoginMode::NewPassword || m_door == LoginMode::OwnPassword);
    m_other->setVisible(isNew || m_door == LoginMode::NewPassword || m_door == LoginMode::Locked ||
                        m_door == LoginMode::OwnPassword);
    m_change->setVisible(m_door == LoginMode::Locked);
    m_guest->setVisible(m_door == LoginMode::Login);
    m_keep->setVisible(m_kept && (m_door == LoginMode::Login || m_door == LoginMode::NewPassword));
    for (const auto& [input, caption] : m_captions)
        caption->setVisible(input->isVisibleTo(m_card));
}

void LoginPage::setLockedBy(const QString& username, bool inExam)
{
    m_lockedBy = username;
    m_isLockedInExam = inExam;
    retranslateUi();
}

void LoginPage::retranslateUi()
{
    m_language->setText(text::Language::nameOf(text::Language::current()));
    m_language->setAccessibleName(tr("Language: %1").arg(m_language->text()));
    m_language->setToolTip(tr("Choose the language"));
    nameQuestion();
    //: Back, without having changed the password
    m_other->setText(m_door == LoginMode::OwnPassword ? tr("Cancel")
                     : m_door == LoginMode::NewSchool ? tr("Back")
                                                      : tr("Switch user"));
    m_change->setText(tr("Change my password"));
    m_change->setAccessibleName(m_change->text());
    m_guest->setText(tr("Practise without login"));
    const auto name = [this](QLineEdit* input, const QString& words) {
        m_captions[input]->setText(words);
        input->setAccessibleName(words);
    };
    name(m_name, tr("Username"));
    name(m_given, tr("Given name"));
    name(m_family, tr("Family name"));
    name(m_old, tr("Current password"));
    name(m_password, m_door == LoginMode::Login         ? tr("Password or one-time code")
                     : m_door == LoginMode::OwnPassword ? tr("New password")
                                                        : tr("Password"));
    name(m_again, m_door == LoginMode::OwnPassword ? tr("Confirm new password") : tr("Confirm password"));
    m_tryAgain->setText(tr("Try again"));
    //: %1: day and time
    m_restore->setText(
        tr("Restore backup (%1)").arg(QLocale().toString(m_backupMade.toLocalTime(), QLocale::ShortFormat)));
    m_restore->setToolTip(brokenIntoLines(
        tr("Attempts on this computer that are in no backup are added again. Changes that teachers and admins made "
           "after the backup are lost. The current file is kept next to the restored one.")));
    for (QPushButton* button : {m_go, m_other, m_guest, m_tryAgain, m_restore})
        button->setAccessibleName(button->text());
    m_waiting->setText(m_isOpening ? tr("Opening the school's database …") : tr("Waiting for the school's database …"));
    m_keep->setText(tr("Save the attempt just graded as mine"));
    m_keep->setAccessibleName(m_keep->text());
    //: %1: a lesson or a tooth
    m_keep->setToolTip(brokenIntoLines(
        m_kept ? tr("%1: saved for the user who logs in. If the box is not checked, the attempt is not saved.")
                     .arg(m_kept())
               : QString()));
    m_guest->setToolTip(brokenIntoLines(tr("Drill and get a grade; nothing is saved")));
}

/// Sets the title, the explanation and the button for the current login mode.
void LoginPage::nameQuestion()
{
    switch (m_door) {
    case LoginMode::Login:
        m_title->setText(tr("Cusp"));
        m_words->setText(tr("Log in to save your attempts."));
        m_go->setText(tr("Log in"));
        break;
    case LoginMode::NewPassword:
        m_title->setText(tr("Choose a password"));
        m_words->setText(tr("The one-time code is correct. Choose your own password: at least eight characters."));
        m_go->setText(tr("Set the password"));
        break;
    case LoginMode::OwnPassword:
        m_title->setText(tr("Change your password"));
        m_words->setText(tr("At least eight characters."));
        m_go->setText(tr("Change the password"));
        break;
    case LoginMode::Welcome:
        m_title->setText(tr("Welcome to Cusp"));
        m_words->setText(m_backupMade.isValid()
                             //: %1: a file
                             ? tr("The school's database was not found: %1 has no users. Restore the backup below, or "
                                  "create a new school and become its admin.")
                                   .arg(m_where)
                             : tr("Drill a virtual tooth and see what to do better."));
        break;
    case LoginMode::NewSchool:
        m_title->setText(tr("Set up a school"));
        m_words->setText(tr("No users yet. You become the admin, and add teachers and students next."));
        m_go->setText(tr("Create the school"));
        break;
    case LoginMode::Locked:
        //: %1: the name a user logs in with
        m_title->setText(tr("Locked by %1").arg(m_lockedBy));
        m_words->setText(m_isLockedInExam ? tr("The work in progress is unchanged, but the exam time keeps running.")
                                          : tr("The work in progress is unchanged."));
        m_go->setText(tr("Unlock"));
        break;
    }
}

void LoginPage::say(std::function<QString()> sentence)
{
    m_saying = std::move(sentence);
    m_said->setText(m_saying ? m_saying() : QString());
    m_said->setVisible(!m_said->text().isEmpty());
}

void LoginPage::showFault(std::function<QString()> sentence)
{
    m_faultWords = std::move(sentence);
    kit::showFault(m_fault, m_faultWords ? m_faultWords() : QString());
}

void LoginPage::setOpening(bool isOpening)
{
    m_isOpening = isOpening;
    retranslateUi();
    updateWaiting();
}

void LoginPage::updateWaiting()
{
    // If the database cannot be opened, the reason and the automatic retry are shown instead.
    const bool isWaiting = m_isBusy || (m_isOpening && m_unreachable->isHidden());
    if (!isWaiting) {
        m_untilTold->stop();
        m_waiting->hide();
    } else if (m_waiting->isHidden() && !m_untilTold->isActive()) {
        m_untilTold->start();
    }
}

void LoginPage::setUnreachable(const QString& sentence)
{
    m_unreachable->setText(sentence);
    m_unreachable->setVisible(!sentence.isEmpty());
    m_tryAgain->setVisible(!sentence.isEmpty());
    if (sentence.isEmpty())
        showFault({});  // hides the error of a database that could not be read
    setBusy(false);
}

void LoginPage::offerToKeep(std::function<QString()> work, bool isTicked)
{
    m_kept = std::move(work);
    m_keep->setChecked(isTicked);
    arrange();
    retranslateUi();
}

bool LoginPage::keeps() const
{
    return m_kept && m_keep->isChecked() && !m_keep->isHidden();
}

void LoginPage::offerBackup(const QDateTime& made, const QString& where)
{
    m_where = where;
    m_backupMade = made;
    m_restore->setVisible(made.isValid());
    retranslateUi();
}

void LoginPage::setBusy(bool busy)
{
    m_isBusy = busy;
    if (busy)
        setFocus();  // otherwise the next button would get the focus, and a second Return would press it
    for (QWidget* input :
         {static_cast<QWidget*>(m_name), static_cast<QWidget*>(m_given), static_cast<QWidget*>(m_family),
          static_cast<QWidget*>(m_old), static_cast<QWidget*>(m_change), static_cast<QWidget*>(m_password),
          static_cast<QWidget*>(m_again), static_cast<QWidget*>(m_go), static_cast<QWidget*>(m_other),
          static_cast<QWidget*>(m_tryAgain), static_cast<QWidget*>(m_restore)})
        input->setEnabled(!busy);
    updateWaiting();
    if (!busy && window()->focusWidget() == this)
        firstInput()->setFocus();
}

void LoginPage::refuse(std::function<QString()> sentence)
{
    setBusy(false);
    showFault(std::move(sentence));
    // If the login mode has changed, the user has typed nothing in this one yet.
    const bool isEmpty = m_password->text().isEmpty() && m_name->isVisible() && m_name->text().isEmpty();
    QLineEdit* const again = m_old->isVisible() ? m_old : isEmpty ? m_name : m_password;
    again->setFocus();
    again->selectAll();
}

void LoginPage::refuseNewPassword(std::function<QString()> sentence)
{
    setBusy(false);
    showFault(std::move(sentence));
    m_password->clear();
    m_again->clear();
    m_password->setFocus();
}

bool LoginPage::areNamesFit()
{
    QLineEdit* wrong = nullptr;
    std::function<QString()> why;
    if (!database::normalUsername(m_name->text().toStdString())) {
        wrong = m_name;
        why = [] { return tr("A username has 1 to 64 characters: the letters a to z, digits and . _ - @."); };
    }
    for (QLineEdit* one : {m_family, m_given})
        if (wrong == nullptr && !database::canBeSeen(one->text().trimmed().toStdString())) {
            wrong = one;
            why = [] { return tr("This name contains invisible characters. Type it again."); };
        }
    if (wrong == nullptr)
        return true;
    showFault(std::move(why));
    wrong->setFocus();
    wrong->selectAll();
    return false;
}

void LoginPage::submit()
{
    if (m_isBusy)
        return;
    showFault({});
    const QString password = m_password->text();
    if (m_again->isVisibleTo(m_card) && m_again->text() != password) {
        refuse([] { return tr("The passwords do not match. Type the second one again."); });
        m_again->setFocus();
        m_again->selectAll();
        return;
    }
    if (m_door == LoginMode::NewSchool && !areNamesFit())
        return;
    switch (m_door) {
    case LoginMode::Welcome:
        break;
    case LoginMode::Login:
        if (m_name->text().trimmed().isEmpty() || password.isEmpty()) {
            (password.isEmpty() && !m_name->text().isEmpty() ? m_password : m_name)->setFocus();
            return;
        }
        setBusy(true);
        emit loginRequested(m_name->text(), password);
        break;
    case LoginMode::Locked:
        if (password.isEmpty()) {  // an accidental Return does not count as a wrong password
            m_password->setFocus();
            return;
        }
        setBusy(true);
        emit loginRequested(m_lockedBy, password);
        break;
    case LoginMode::NewPassword:
        setBusy(true);
        emit codeRequested(m_name->text(), m_code, password);
        break;
    case LoginMode::OwnPassword:
        setBusy(true);
        emit passwordChangeRequested(m_old->text(), password);
        break;
    case LoginMode::NewSchool:
        setBusy(true);
        emit schoolRequested({m_name->text().toStdString(), m_given->text().trimmed().toStdString(),
                              m_family->text().trimmed().toStdString(), database::Role::Admin},
                             password);
        break;
    }
}

}  // namespace ui::people
