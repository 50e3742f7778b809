// Reads the JSON Schema of scenes.

export class Schema {
  constructor(json) {
    this.json = json;
    this.definitions = json.$defs ?? {};
  }

  resolve(schema) {
    let found = schema;
    while (found?.$ref) found = { ...this.definitions[found.$ref.replace("#/$defs/", "")], ...without(found, "$ref") };
    return found;
  }

  // Returns the members of a group as pairs [name, schema], including members whose names the scene chooses.
  membersOf(schema, value) {
    const members = Object.entries(schema.properties ?? {});
    if (schema.additionalProperties && typeof schema.additionalProperties === "object")
      for (const name of Object.keys(value ?? {}))
        if (!(name in (schema.properties ?? {}))) members.push([name, schema.additionalProperties]);
    return members;
  }
}

const without = (object, key) => Object.fromEntries(Object.entries(object).filter(([name]) => name !== key));

// Returns the alternatives of a schema as one list. Alternatives may contain further alternatives.
const flat = (schema) => (schema.anyOf ?? schema.oneOf)?.flatMap(flat) ?? [schema];

// Splits a schema with several alternatives into {plain, moving, group}: plain value, keyframes, group.
export function forms(schema) {
  const several = flat(schema);
  const all = several.some((form) => form.type || form.enum || form.const !== undefined) ? several : [schema];
  const moving = all.find((form) => form.properties?.keys);
  const group = all.find((form) => form.type === "object" && form !== moving && form.properties);
  const plain = all.find((form) => form !== moving && form !== group) ?? group;
  return { plain, moving, group };
}

export const isGroup = (schema) => {
  const { plain, group } = forms(schema);
  return Boolean(group) || (plain?.type === "object" && Boolean(plain.properties || plain.additionalProperties));
};

// Splits a description such as "What it is. Unit: m. Left out: 4." into unit and text.
export function wordsOf(schema) {
  const text = schema.description ?? "";
  const unit = /Unit: ([^.]*?)\.(\s|$)/.exec(text)?.[1] ?? "";
  return { unit, text: text.replace(/\s*Unit: [^.]*?\.(?=\s|$)/, "") };
}

export const isColor = (schema) => {
  const { plain } = forms(schema);
  return plain?.type === "array" && plain.minItems === 3 && plain.items?.minimum === 0 &&
    /colou?r|RGB|zenith|horizon|ground|light/i.test(schema.description ?? "");
};
