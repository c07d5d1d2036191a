// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/AdminPage.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/admin/AuditPart.h"
#include "ui/admin/BackupPart.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/admin/StationPart.h"
#include "ui/kit/Actions.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::admin {

using namespace ui::kit;

AdminPage::AdminPage(const Actions& actions, QWidget* parent)
    : Page(actions, parent), m_choice(new QButtonGroup(this)), m_stack(new QStackedWidget(this)),
      m_people(new PeoplePart(m_stack)), m_roster(new RosterPart(m_stack)), m_backups(new BackupPart(m_stack)),
      m_audit(new AuditPart(m_stack)), m_station(new StationPart(m_stack))
{
    auto* choice = new QHBoxLayout;
    choice->setContentsMargins(kSpace4, 0, kSpace4, 0);
    choice->setSpacing(kSpace1);
    const auto offer = [&](Part part, QWidget* what, const auto& say) {
        auto* button = new QPushButton(this);
        button->setProperty("kind", "segment");
        button->setCheckable(true);
        button->setAutoDefault(false);
        text::bindTranslation(button, [button, say] {
            button->setText(say());
            button->setAccessibleName(say());
        });
        m_choice->addButton(button, part);
        choice->addWidget(button);
        m_stack->addWidget(what);
    };
    offer(People, m_people, [] { return tr("People"); });
    offer(Roster, m_roster, [] { return tr("Class list"); });
    offer(Backups, m_backups, [] { return tr("Backups"); });
    offer(Audit, m_audit, [] { return tr("Audit"); });
    offer(Station, m_station, [] { return tr("This computer"); });
    choice->addStretch(1);
    // A page of its own that every user may view. It is linked here because presets are saved in the database.
    choice->addWidget(pageButton(actions.presets, "quiet", this));
    m_choice->button(People)->setChecked(true);
    m_stack->setContentsMargins(kSpace4, 0, kSpace4, kSpace2);
    body()->addLayout(choice);
    body()->addWidget(m_stack, 1);
    connect(m_choice, &QButtonGroup::idClicked, this, [this](int part) { show(static_cast<Part>(part)); });
    text::bindTranslation(this, [this] { setTitle(tr("School")); });
}

AdminPage::Part AdminPage::part() const
{
    return static_cast<Part>(m_choice->checkedId());
}

void AdminPage::setLessonTitles(const text::LessonTitles& titles)
{
    m_backups->setLessonTitles(titles);
    m_audit->setLessonTitles(titles);
}

void AdminPage::show(Part part)
{
    m_choice->button(part)->setChecked(true);
    m_stack->setCurrentIndex(part);
    m_stack->currentWidget()->setFocus();
    emit partOpened(part);
}

}  // namespace ui::admin
