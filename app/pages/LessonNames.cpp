// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/LessonNames.h"

#include <algorithm>
#include <climits>
#include <utility>

#include "app/threads/Background.h"
#include "lessons/Assignment.h"
#include "lessons/Rubric.h"
#include "lessons/ScoreSheet.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/Texts.h"

namespace app {

ui::text::CriterionNames criterionNames(const lessons::Rubric& rubric)
{
    ui::text::CriterionNames names;
    for (const lessons::CriterionRule& rule : rubric.criteria) {
        lessons::Criterion criterion;
        criterion.id = rule.id;
        criterion.title = rule.title;
        criterion.measure = rule.measure;
        names[rule.id] = ui::text::criterionName(criterion);
    }
    return names;
}

LessonNames::LessonNames(std::function<database::Login()> who) : m_who(std::move(who)) {}

void LessonNames::read(const std::function<void()>& then)
{
    inBackground(
        this, [] { return lessons::readCatalog(lessons::teachersFolder()); },
        [this, then, who = m_who()](std::vector<lessons::CatalogEntry>& entries) {
            if (m_who() != who)
                return;
            m_catalog = std::move(entries);
            std::stable_sort(m_catalog.begin(), m_catalog.end(), [](const auto& a, const auto& b) {
                const auto place = [](const lessons::CatalogEntry& entry) {
                    return entry.isFaulty() ? std::pair(INT_MAX, std::string())
                                            : ui::text::groupPlace(*entry.read.lesson);
                };
                return place(a) < place(b);
            });
            translate();
            then();
        });
}

void LessonNames::translate()
{
    m_titles.clear();
    for (const lessons::CatalogEntry& entry : m_catalog)
        if (!entry.isFaulty())
            m_titles[QString::fromStdString(entry.read.lesson->id)] = ui::text::said(entry.read.lesson->title);
    emit changed();
}

const lessons::Lesson* LessonNames::find(const std::string& id) const
{
    for (const lessons::CatalogEntry& entry : m_catalog)
        if (!entry.isFaulty() && entry.read.lesson->id == id)
            return &*entry.read.lesson;
    return nullptr;
}

std::map<std::string, ui::text::CriterionNames> LessonNames::criteria() const
{
    std::map<std::string, ui::text::CriterionNames> criteria;
    if (const auto free = lessons::practiceRubric())
        criteria[{}] = criterionNames(*free);
    for (const lessons::CatalogEntry& entry : m_catalog)
        if (!entry.isFaulty())
            criteria[entry.read.lesson->id] = criterionNames(entry.read.lesson->rubric);
    return criteria;
}

std::vector<ui::people::LessonOffer> LessonNames::offers() const
{
    std::vector<ui::people::LessonOffer> offers;
    for (const lessons::CatalogEntry& entry : m_catalog) {
        if (entry.isFaulty())
            continue;
        const lessons::Lesson& one = *entry.read.lesson;
        offers.push_back({one.id, ui::text::said(one.title), ui::text::toothWords(one), ui::text::groupName(one),
                          one.hash, one.version});
    }
    return offers;
}

}  // namespace app
