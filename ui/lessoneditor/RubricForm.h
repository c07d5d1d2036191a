// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QWidget>

#include "lessons/LessonReader.h"

class QCheckBox;
class QDoubleSpinBox;
class QJsonObject;
class QLabel;
class QVBoxLayout;

namespace ui::lessoneditor {

/// The part of the lesson form for the rubric: the tolerance and weight of each criterion, and the pass mark.
class RubricForm final : public QWidget
{
    Q_OBJECT
public:
    explicit RubricForm(QWidget* parent);

    /// Sets the inputs. Creates them again only if the criteria have changed.
    void offerCriteria(const std::vector<::lessons::CriterionRule>& criteria);
    /// Discards the inputs' labels when the language changes. The inputs must be offered again.
    void forgetWords();
    /// Shows the values of a rubric.
    /// @param rubric  the JSON object; it may be invalid
    void showValues(const QJsonObject& rubric);
    /// Shows the errors of the rubric beside their inputs. Returns all other errors.
    [[nodiscard]] std::vector<::lessons::ValidationIssue>
    takeFaults(const std::vector<::lessons::ValidationIssue>& faults);

    /// Returns the number of decimals of a tolerance in this unit.
    [[nodiscard]] static int decimalsOf(const std::string& unit);

signals:
    /// Emitted when the user has changed a number of a criterion.
    /// @param key  "tolerance", "weight", "target" or "span"
    void criterionSet(int index, const char* key, double value);
    void passMarkSet(double points);

private:
    struct Criterion
    {
        std::string id;
        QLabel* name = nullptr;
        QDoubleSpinBox* tolerance = nullptr;
        QDoubleSpinBox* weight = nullptr;  ///< null for a critical criterion
        QDoubleSpinBox* target = nullptr;
        QDoubleSpinBox* span = nullptr;  ///< null for a critical criterion
        QWidget* more = nullptr;         ///< the row of target and span
        QLabel* fault = nullptr;

        void call(const QString& title) const;
    };

    [[nodiscard]] bool offers(const std::vector<::lessons::CriterionRule>& criteria) const;
    [[nodiscard]] QWidget* makeMore(const ::lessons::CriterionRule& rule, Criterion& inputs);
    void connectInput(QDoubleSpinBox* input, int index, const char* key);
    void showMore();
    void sumUp();

    QVBoxLayout* m_slot = nullptr;
    QWidget* m_inputs = nullptr;
    std::vector<Criterion> m_criteria;
    QCheckBox* m_more = nullptr;  ///< targets and spans are shown
    QLabel* m_sum = nullptr;
    QDoubleSpinBox* m_passMark = nullptr;
    bool m_isFilling = false;
};

}  // namespace ui::lessoneditor
