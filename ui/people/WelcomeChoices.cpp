// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/WelcomeChoices.h"

#include <QCommandLinkButton>
#include <QVBoxLayout>

#include "ui/shell/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::people {
namespace {

using namespace ui::shell;

constexpr int kHeightPx = 92;

}  // namespace

WelcomeChoices::WelcomeChoices(QWidget* parent)
    : QWidget(parent), m_practise(new QCommandLinkButton(this)), m_school(new QCommandLinkButton(this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    m_practise->setObjectName(QStringLiteral("practiseNow"));
    m_practise->setProperty("kind", "filled");
    m_school->setObjectName(QStringLiteral("setUpSchool"));
    for (QCommandLinkButton* button : {m_practise, m_school}) {
        button->setIcon({});
        button->setFont(typeface(kBody));
        button->setMinimumHeight(kHeightPx);
        button->setAutoDefault(true);
        column->addWidget(button);
    }
    connect(m_practise, &QPushButton::clicked, this, &WelcomeChoices::practiceWanted);
    connect(m_school, &QPushButton::clicked, this, &WelcomeChoices::schoolWanted);
    text::inEveryLanguage(this, [this] { speak(); });
}

QWidget* WelcomeChoices::first() const
{
    return m_practise;
}

void WelcomeChoices::speak()
{
    m_practise->setText(tr("Practise now"));
    m_practise->setDescription(tr("A tooth with decay is ready. Nothing is saved."));
    m_school->setText(tr("Set up a school"));
    m_school->setDescription(tr("Users, lessons and score histories. You become the admin."));
    for (QCommandLinkButton* button : {m_practise, m_school}) {
        button->setAccessibleName(button->text());
        button->setAccessibleDescription(button->description());
    }
}

}  // namespace ui::people
