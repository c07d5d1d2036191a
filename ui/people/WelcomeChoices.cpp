// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/WelcomeChoices.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::people {
namespace {

using namespace ui::kit;

constexpr int kHeightPx = 92;

}  // namespace

WelcomeChoices::WelcomeChoices(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    m_practise = addChoice("practiseNow", *column);
    m_practise.button->setProperty("kind", "filled");
    // White on the accent colour, like the text of other filled buttons.
    for (QLabel* label : {m_practise.title, m_practise.words})
        label->setStyleSheet(QStringLiteral("color: white"));
    setFocusProxy(m_practise.button);
    m_school = addChoice("setUpSchool", *column);
    connect(m_practise.button, &QPushButton::clicked, this, &WelcomeChoices::practiceRequested);
    connect(m_school.button, &QPushButton::clicked, this, &WelcomeChoices::schoolRequested);
    text::bindTranslation(this, [this] { retranslateUi(); });
}

WelcomeChoices::Choice WelcomeChoices::addChoice(const char* name, QVBoxLayout& column)
{
    Choice choice;
    choice.button = new QPushButton(this);
    choice.button->setObjectName(QLatin1String(name));
    choice.button->setAutoDefault(true);
    choice.button->setFixedHeight(kHeightPx);
    column.addWidget(choice.button);
    auto* lines = new QVBoxLayout(choice.button);
    lines->setContentsMargins(kSpace4, kSpace2, kSpace4, kSpace2);
    lines->setSpacing(kSpace1);
    choice.title = new QLabel(choice.button);
    choice.title->setFont(typeface(kTitle, QFont::DemiBold));
    choice.words = new QLabel(choice.button);
    choice.words->setFont(typeface(kBody));
    lines->addStretch(1);
    for (QLabel* label : {choice.title, choice.words}) {
        label->setWordWrap(true);
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
        lines->addWidget(label);
    }
    lines->addStretch(1);
    return choice;
}

void WelcomeChoices::retranslateUi()
{
    m_practise.title->setText(tr("Practise now"));
    m_practise.words->setText(tr("A tooth with decay is ready. Nothing is saved."));
    m_school.title->setText(tr("Set up a school"));
    m_school.words->setText(tr("Users, lessons and score histories. You become the admin."));
    for (const Choice& choice : {m_practise, m_school}) {
        choice.button->setAccessibleName(choice.title->text());
        choice.button->setAccessibleDescription(choice.words->text());
    }
}

}  // namespace ui::people
