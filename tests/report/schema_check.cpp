// SPDX-License-Identifier: MIT
#include "schema_check.h"

// GCC 12 takes std::regex, which the validator uses, for uninitialised when sanitizers are on.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "sample_results.h"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

std::string lixel::test::schemaError(const std::string& text) { return schemaError(text, "results.schema.json"); }

std::string lixel::test::schemaError(const std::string& text, const std::string& schemaFile)
{
    using Adapter = valijson::adapters::NlohmannJsonAdapter;
    const auto schemaJson = nlohmann::json::parse(readWhole(LIXEL_SOURCE_DIR "/docs/" + schemaFile));
    valijson::Schema schema;
    valijson::SchemaParser().populateSchema(Adapter(schemaJson), schema);

    const auto json = nlohmann::json::parse(text);
    valijson::ValidationResults errors;
    valijson::Validator().validate(schema, Adapter(json), &errors);
    std::string all;
    for (valijson::ValidationResults::Error error; errors.popError(error);) {
        for (const std::string& part : error.context) all += part;
        all += ": " + error.description + "\n";
    }
    return all;
}
