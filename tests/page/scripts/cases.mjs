import {readFileSync} from "node:fs";

/// The cases that page_cases.cpp has written to the file that the environment variable PAGE_CASES names.
export const cases = JSON.parse(readFileSync(process.env.PAGE_CASES, "utf8"));
