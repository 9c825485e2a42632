import js from '@eslint/js';
import { defineConfig, globalIgnores } from 'eslint/config';
import tseslint from 'typescript-eslint';

const nodeGlobals = Object.fromEntries(
  ['Buffer', 'URL', 'console', 'fetch', 'performance', 'process'].map((name) => [name, 'readonly']),
);

export default defineConfig(
  globalIgnores(['build/', 'dist/', '.toolchain/', 'web/core/generated/', 'cmake/']),
  js.configs.recommended,
  {
    files: ['**/*.ts'],
    extends: [tseslint.configs.recommendedTypeChecked],
    languageOptions: { parserOptions: { projectService: true } },
    rules: {
      '@typescript-eslint/consistent-type-imports': 'error',
      '@typescript-eslint/explicit-module-boundary-types': 'error',
      // A leading underscore says that a name is there for its place alone.
      '@typescript-eslint/no-unused-vars': [
        'error',
        { argsIgnorePattern: '^_', varsIgnorePattern: '^_' },
      ],
      // Numbers in templates are what most of the messages and all of the exporters consist of.
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
    },
  },
  { files: ['**/*.{js,mjs}'], languageOptions: { globals: nodeGlobals } },
  {
    // What a page loads as it is.
    files: ['web/app/public/*.js'],
    languageOptions: {
      sourceType: 'script',
      globals: { document: 'readonly', MutationObserver: 'readonly' },
    },
  },
  { rules: { eqeqeq: 'error', 'prefer-const': 'error', 'no-var': 'error' } },
);
